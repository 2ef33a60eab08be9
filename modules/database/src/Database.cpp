// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/database/Database.h"

#include <sqlite3.h>

#include "Content.h"

namespace perilymph::database {

void Statement::Finalize::operator()(sqlite3_stmt* statement) const noexcept
{
  sqlite3_finalize(statement);
}

void Statement::bind(int parameter, double value)
{
  sqlite3_bind_double(statement_.get(), parameter + 1, value);
}

void Statement::bind(int parameter, std::int64_t value)
{
  sqlite3_bind_int64(statement_.get(), parameter + 1, value);
}

void Statement::bind(int parameter, const std::string& text)
{
  sqlite3_bind_text(statement_.get(), parameter + 1, text.data(), static_cast<int>(text.size()),
                    SQLITE_TRANSIENT);
}

void Statement::bind(int parameter, std::span<const unsigned char> bytes)
{
  sqlite3_bind_blob(statement_.get(), parameter + 1, bytes.data(), static_cast<int>(bytes.size()),
                    SQLITE_TRANSIENT);
}

Statement::Step Statement::step()
{
  switch (sqlite3_step(statement_.get())) {
    case SQLITE_ROW:
      return Step::row;
    case SQLITE_DONE:
      return Step::done;
    default:
      return Step::failed;
  }
}

void Statement::reset() { sqlite3_reset(statement_.get()); }

Statement::Type Statement::type(int column) const
{
  switch (sqlite3_column_type(statement_.get(), column)) {
    case SQLITE_INTEGER:
      return Type::integer;
    case SQLITE_FLOAT:
      return Type::real;
    case SQLITE_TEXT:
      return Type::text;
    case SQLITE_BLOB:
      return Type::blob;
    default:
      return Type::null;
  }
}

std::string Statement::text(int column) const
{
  const unsigned char* letters = sqlite3_column_text(statement_.get(), column);
  const auto size = static_cast<std::size_t>(sqlite3_column_bytes(statement_.get(), column));
  return letters ? std::string(reinterpret_cast<const char*>(letters), size) : std::string();
}

std::int64_t Statement::integer(int column) const
{
  return sqlite3_column_int64(statement_.get(), column);
}

double Statement::real(int column) const { return sqlite3_column_double(statement_.get(), column); }

std::span<const unsigned char> Statement::blob(int column) const
{
  const void* bytes = sqlite3_column_blob(statement_.get(), column);
  return {static_cast<const unsigned char*>(bytes),
          static_cast<std::size_t>(sqlite3_column_bytes(statement_.get(), column))};
}

Database::Database(std::unique_ptr<Content> content) : content_(std::move(content)) {}
Database::Database(Database&&) noexcept = default;
Database& Database::operator=(Database&&) noexcept = default;
Database::~Database() = default;

Result<Database> Database::inMemory()
{
  auto content = std::make_unique<Content>();
  sqlite3* opened = nullptr;
  const int outcome = sqlite3_open(":memory:", &opened);
  content->database.reset(opened);
  if (outcome != SQLITE_OK) return Error{"SQLite cannot be set up"};
  return Database(std::move(content));
}

const std::string& Database::note() const noexcept { return content_->note; }

bool Database::isShared() const noexcept { return content_->isShared; }

std::int64_t Database::version() const noexcept { return content_->version; }

Result<void> Database::run(const std::string& sql)
{
  content_->watch->instructions = 0;
  if (sqlite3_exec(content_->database.get(), sql.c_str(), nullptr, nullptr, nullptr) != SQLITE_OK)
    return Error{lastError()};
  return {};
}

Result<Statement> Database::prepare(const std::string& sql) const
{
  content_->watch->instructions = 0;
  sqlite3_stmt* prepared = nullptr;
  if (sqlite3_prepare_v2(content_->database.get(), sql.c_str(), -1, &prepared, nullptr) !=
      SQLITE_OK)
    return Error{lastError()};
  Statement statement;
  statement.statement_.reset(prepared);
  return statement;
}

Result<void> Database::checkPages() const { return content_->checkPages(); }

void Database::abandon()
{
  static_cast<void>(run("PRAGMA wal_checkpoint(TRUNCATE)"));
  int ignored = 0;
  sqlite3_db_config(content_->database.get(), SQLITE_DBCONFIG_NO_CKPT_ON_CLOSE, 1, &ignored);
  content_->database.reset();
}

std::string Database::lastError() const { return content_->lastError(); }

bool Database::isBusy() const noexcept
{
  const int code = sqlite3_errcode(content_->database.get());
  return code == SQLITE_BUSY || code == SQLITE_LOCKED;
}

bool Database::wasStopped() const noexcept { return content_->watch->wasStopped; }

bool Database::hasToStop() const noexcept
{
  Watch& watch = *content_->watch;
  watch.wasStopped = watch.wasStopped || watch.stop.stop_requested();
  return watch.wasStopped;
}

Error Database::readingError(const Sentence& reason) const { return content_->error(reason); }

std::string creationOf(const FileKind& kind)
{
  std::string sql = "BEGIN; PRAGMA application_id=" + std::to_string(kind.applicationId) +
                    "; PRAGMA user_version=" + std::to_string(kind.newestVersion) + ";";
  for (const std::string& table : kind.tables) sql += table + ';';
  for (const std::string& view : kind.views) sql += view + ';';
  return sql;
}

}  // namespace perilymph::database
