// SPDX-License-Identifier: BSD-3-Clause
#include "Content.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "OwnFilesOnly.h"

namespace perilymph::database {

namespace {

namespace fs = std::filesystem;

constexpr int instructionsBetween = 1000;

/// SQLite's progress handler: a nonzero result interrupts the query.
int progressed(void* context)
{
  Watch& watch = *static_cast<Watch*>(context);
  watch.instructions += instructionsBetween;
  if (watch.maxInstructions > 0 && watch.instructions > watch.maxInstructions)
    watch.isExhausted = true;
  watch.wasStopped = watch.wasStopped || watch.stop.stop_requested();
  return watch.isExhausted || watch.wasStopped ? 1 : 0;
}

/// Hardens SQLite against an untrusted file: nothing in its schema is executed, and the length of
/// values is bounded. (SQLite, "Defense Against The Dark Arts".)
void distrust(sqlite3* database)
{
  const std::pair<int, int> limits[] = {{SQLITE_LIMIT_LENGTH, 4 << 20},
                                        {SQLITE_LIMIT_SQL_LENGTH, 100'000},
                                        {SQLITE_LIMIT_COLUMN, 100},
                                        {SQLITE_LIMIT_EXPR_DEPTH, 20},
                                        {SQLITE_LIMIT_ATTACHED, 0},
                                        {SQLITE_LIMIT_TRIGGER_DEPTH, 1},
                                        {SQLITE_LIMIT_COMPOUND_SELECT, 2},
                                        {SQLITE_LIMIT_VDBE_OP, 25'000},
                                        {SQLITE_LIMIT_LIKE_PATTERN_LENGTH, 100},
                                        {SQLITE_LIMIT_FUNCTION_ARG, 8}};
  for (const auto& [limit, value] : limits) sqlite3_limit(database, limit, value);
  int ignored = 0;
  sqlite3_db_config(database, SQLITE_DBCONFIG_DEFENSIVE, 1, &ignored);
  for (const int off : {SQLITE_DBCONFIG_TRUSTED_SCHEMA, SQLITE_DBCONFIG_ENABLE_TRIGGER,
                        SQLITE_DBCONFIG_ENABLE_VIEW, SQLITE_DBCONFIG_ENABLE_LOAD_EXTENSION})
    sqlite3_db_config(database, off, 0, &ignored);
  sqlite3_exec(database, "PRAGMA cell_size_check=ON; PRAGMA mmap_size=0; PRAGMA temp_store=MEMORY",
               nullptr, nullptr, nullptr);
}

/// A file: URI with every character escaped, so that the name is taken literally.
std::string uriOf(const fs::path& file)
{
  std::string uri = "file:";
  constexpr const char* hexadecimal = "0123456789abcdef";
  for (const char letter : fs::absolute(file).string()) {
    const auto code = static_cast<unsigned char>(letter);
    uri += {'%', hexadecimal[code >> 4], hexadecimal[code & 0xf]};
  }
  return uri;
}

std::int64_t pragma(sqlite3* database, const char* sql)
{
  sqlite3_stmt* statement = nullptr;
  if (sqlite3_prepare_v2(database, sql, -1, &statement, nullptr) != SQLITE_OK) return 0;
  const std::int64_t number =
      sqlite3_step(statement) == SQLITE_ROW ? sqlite3_column_int64(statement, 0) : 0;
  sqlite3_finalize(statement);
  return number;
}

}  // namespace

Error Database::Content::error(const Sentence& reason) const
{
  if (watch->wasStopped) return Error{"Reading %1 was stopped.", file};
  return Error{"%1 is damaged (%2). %3", file, reason, remedy};
}

Result<void> Database::Content::open(const fs::path& place, Access access)
{
  const char* vfs = access == Access::write ? ownFilesOnly() : withoutJournals();
  if (vfs == nullptr) return Error{"SQLite cannot be set up"};
  const bool isImmutable = access == Access::immutable;
  const int flags = SQLITE_OPEN_URI | SQLITE_OPEN_FULLMUTEX | SQLITE_OPEN_NOFOLLOW |
                    (isImmutable ? SQLITE_OPEN_READONLY : SQLITE_OPEN_READWRITE);
  sqlite3* opened = nullptr;
  const int outcome = sqlite3_open_v2((uriOf(place) + (isImmutable ? "?immutable=1" : "")).c_str(),
                                      &opened, flags, vfs);
  database.reset(opened);
  if (outcome != SQLITE_OK)
    return Error{std::string(opened ? sqlite3_errmsg(opened) : "out of memory")};
  // Another program that reads a recording in progress locks it only briefly.
  sqlite3_busy_timeout(opened, 2000);
  sqlite3_progress_handler(opened, instructionsBetween, progressed, watch.get());
  distrust(opened);
  if (access != Access::trial) return {};
  int ignored = 0;
  sqlite3_db_config(opened, SQLITE_DBCONFIG_NO_CKPT_ON_CLOSE, 1, &ignored);
  // The index of the log is then in memory.
  sqlite3_exec(opened, "PRAGMA wal_autocheckpoint=0; PRAGMA locking_mode=EXCLUSIVE", nullptr,
               nullptr, nullptr);
  sqlite3_busy_timeout(opened, 100);  // others that try it are soon done
  return {};
}

Result<void> Database::Content::check(const FileKind& kind)
{
  const std::int64_t application = pragma(database.get(), "PRAGMA application_id");
  const int code = sqlite3_errcode(database.get());
  if (code == SQLITE_NOTADB || code == SQLITE_CORRUPT || watch->wasStopped)
    return error(std::string(sqlite3_errmsg(database.get())));
  if (pragma(database.get(), "PRAGMA page_count") == 0)
    return Error{
        "%1 is empty: the program that began it ended before it wrote anything. Delete it.", file};
  const bool isFormer = application != 0 && application == kind.formerApplicationId;
  if (application != kind.applicationId && !isFormer)
    return Error{"%1 is not %2. %3", file, kind.name, kind.choice};
  version = pragma(database.get(), "PRAGMA user_version");
  if (version > kind.newestVersion)
    return Error{"%1 has format %2; this program reads up to %3. Open it with a newer version.",
                 file, version, kind.newestVersion};
  if (version < 1) return error(Sentence{"its format has no number"});

  sqlite3_stmt* prepared = nullptr;
  const int outcome = sqlite3_prepare_v2(
      database.get(), "SELECT type, sql FROM sqlite_master ORDER BY rowid", -1, &prepared, nullptr);
  const std::unique_ptr<sqlite3_stmt, int (*)(sqlite3_stmt*)> rows(prepared, sqlite3_finalize);
  if (outcome != SQLITE_OK) return error(std::string(sqlite3_errmsg(database.get())));
  std::vector<std::string> missing = version < kind.tablesSince ? kind.formerTables : kind.tables;
  int step = sqlite3_step(prepared);
  for (; step == SQLITE_ROW; step = sqlite3_step(prepared)) {
    const auto text = [prepared](int column) {
      const unsigned char* letters = sqlite3_column_text(prepared, column);
      return letters ? std::string(reinterpret_cast<const char*>(letters)) : std::string();
    };
    // SQLite's automatic index of a primary key has no statement.
    if (text(0) == "index" && sqlite3_column_type(prepared, 1) == SQLITE_NULL) continue;
    const auto isAmong = [&text](const std::vector<std::string>& views) {
      return std::find(views.begin(), views.end(), text(1)) != views.end();
    };
    if (text(0) == "view" && (isAmong(kind.views) || isAmong(kind.formerViews))) continue;
    const auto found = std::find(missing.begin(), missing.end(), text(1));
    if (text(0) != "table" || found == missing.end())
      return error(Sentence{"it has content that %1 does not have", kind.name});
    missing.erase(found);
  }
  if (step != SQLITE_DONE) return error(std::string(sqlite3_errmsg(database.get())));
  if (!missing.empty()) return error(Sentence{"a table is missing"});
  return {};
}

Result<void> Database::Content::checkPages() const
{
  watch->instructions = 0;
  sqlite3_stmt* prepared = nullptr;
  sqlite3_prepare_v2(database.get(), "PRAGMA integrity_check(1)", -1, &prepared, nullptr);
  const std::unique_ptr<sqlite3_stmt, int (*)(sqlite3_stmt*)> rows(prepared, sqlite3_finalize);
  if (!rows || sqlite3_step(prepared) != SQLITE_ROW) return error(lastError());
  const unsigned char* text = sqlite3_column_text(prepared, 0);
  if (text == nullptr || std::string(reinterpret_cast<const char*>(text)) != "ok")
    return error(Sentence{"its pages contradict one another"});
  return {};
}

std::string Database::Content::lastError() const
{
  if (watch->isExhausted) return "reading it does not end";
  return sqlite3_errmsg(database.get());
}

}  // namespace perilymph::database
