#include "Database.h"

#include <sqlite3.h>

namespace perilymph::session {

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

namespace {

/// A file may come from anybody: what its schema says is never run, and no value is so long that
/// memory ends. (SQLite's advice for files from others, "Defense Against The Dark Arts".)
void distrust(sqlite3* database)
{
  constexpr int mostBytes = 64 << 20;
  sqlite3_limit(database, SQLITE_LIMIT_LENGTH, mostBytes);
  int ignored = 0;
  sqlite3_db_config(database, SQLITE_DBCONFIG_DEFENSIVE, 1, &ignored);
  for (const int off : {SQLITE_DBCONFIG_TRUSTED_SCHEMA, SQLITE_DBCONFIG_ENABLE_TRIGGER,
                        SQLITE_DBCONFIG_ENABLE_VIEW, SQLITE_DBCONFIG_ENABLE_LOAD_EXTENSION})
    sqlite3_db_config(database, off, 0, &ignored);
}

}  // namespace

void Database::Close::operator()(sqlite3* database) const noexcept { sqlite3_close_v2(database); }

Result<Database> Database::open(const std::filesystem::path& file, Access access)
{
  // A file: name with every letter escaped means this file, whatever its name contains.
  std::string uri = "file:";
  constexpr const char* hexadecimal = "0123456789abcdef";
  for (const char letter : std::filesystem::absolute(file).string()) {
    const auto code = static_cast<unsigned char>(letter);
    uri += {'%', hexadecimal[code >> 4], hexadecimal[code & 0xf]};
  }
  if (access == Access::immutable) uri += "?immutable=1";

  const int flags = SQLITE_OPEN_URI | SQLITE_OPEN_FULLMUTEX |
                    (access == Access::immutable ? SQLITE_OPEN_READONLY : SQLITE_OPEN_READWRITE);
  sqlite3* opened = nullptr;
  const int outcome = sqlite3_open_v2(uri.c_str(), &opened, flags, nullptr);
  Database database;
  database.database_.reset(opened);
  if (outcome != SQLITE_OK) return Error{opened ? sqlite3_errmsg(opened) : "out of memory"};
  distrust(opened);
  // Another program that looks into a running recording holds it for moments only.
  sqlite3_busy_timeout(opened, 2000);
  return database;
}

Result<Done> Database::run(const std::string& sql)
{
  if (sqlite3_exec(database_.get(), sql.c_str(), nullptr, nullptr, nullptr) != SQLITE_OK)
    return Error{trouble()};
  return Done{};
}

Result<Statement> Database::prepare(const std::string& sql) const
{
  sqlite3_stmt* prepared = nullptr;
  if (sqlite3_prepare_v2(database_.get(), sql.c_str(), -1, &prepared, nullptr) != SQLITE_OK)
    return Error{trouble()};
  Statement statement;
  statement.statement_.reset(prepared);
  return statement;
}

std::int64_t Database::number(const std::string& sql) const
{
  auto statement = prepare(sql);
  if (!statement || statement->step() != Statement::Step::row) return 0;
  return statement->integer(0);
}

std::string Database::trouble() const { return sqlite3_errmsg(database_.get()); }

bool Database::isDamaged() const
{
  const int code = sqlite3_errcode(database_.get());
  return code == SQLITE_NOTADB || code == SQLITE_CORRUPT;
}

}  // namespace perilymph::session
