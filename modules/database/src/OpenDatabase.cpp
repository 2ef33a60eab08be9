// SPDX-License-Identifier: BSD-3-Clause

// Opens a database; checks the file before SQLite reads it.

#include <fcntl.h>
#include <unistd.h>

#include <cstring>
#include <memory>
#include <optional>
#include <stop_token>
#include <utility>
#include <vector>

#include "Companions.h"
#include "Content.h"
#include "perilymph/foundation/AtomicFile.h"

namespace perilymph::database {

namespace {

namespace fs = std::filesystem;

/// Checks with the effective user and group, not the real ones.
bool mayAccess(const fs::path& place, int mode)
{
  return ::faccessat(AT_FDCWD, place.c_str(), mode, AT_EACCESS) == 0;
}

bool mayWrite(const fs::path& file)
{
  const fs::path folder = file.has_parent_path() ? file.parent_path() : fs::path(".");
  return mayAccess(file, W_OK) && mayAccess(folder, W_OK);
}

/// Upper bound of the SQLite instructions that a query over a file of this size needs: a row of
/// about twenty bytes, the smallest of this program, takes ten. A cycle of pages could run forever.
std::int64_t maxInstructionsFor(const fs::path& file)
{
  std::error_code ignored;
  const auto bytes = static_cast<std::int64_t>(fs::file_size(file, ignored));
  return 1'000'000 + 4 * (ignored ? 0 : bytes);
}

/// What is known of a file before SQLite reads it.
struct Inspected {
  fs::path place;  ///< Companion files lie beside the file itself, not beside a link to it.
  FileHeader header;
  Companions companions;
};

using Access = Database::Content::Access;
using Rows = std::unique_ptr<sqlite3_stmt, int (*)(sqlite3_stmt*)>;

Rows rowsOf(sqlite3* database, const std::string& sql)
{
  sqlite3_stmt* prepared = nullptr;
  sqlite3_prepare_v2(database, sql.c_str(), -1, &prepared, nullptr);
  return {prepared, sqlite3_finalize};
}

bool areSame(sqlite3_stmt* one, sqlite3_stmt* other)
{
  for (int i = 0; i < sqlite3_column_count(one); ++i) {
    if (sqlite3_column_type(one, i) != sqlite3_column_type(other, i)) return false;
    // numbers as text with all their digits
    const void* bytes = sqlite3_column_blob(one, i);
    const void* otherBytes = sqlite3_column_blob(other, i);
    const int size = sqlite3_column_bytes(one, i);
    if (size != sqlite3_column_bytes(other, i)) return false;
    if (size > 0 && std::memcmp(bytes, otherBytes, static_cast<std::size_t>(size)) != 0)
      return false;
  }
  return true;
}

/// Whether a query gives all the rows of one file in another, in order, and perhaps more.
bool hasRowsOf(sqlite3* another, sqlite3* file, const std::string& query)
{
  const Rows expected = rowsOf(file, query), found = rowsOf(another, query);
  if (!expected) return true;
  if (!found) return false;
  int step = sqlite3_step(expected.get());
  for (; step == SQLITE_ROW; step = sqlite3_step(expected.get())) do {
      if (sqlite3_step(found.get()) != SQLITE_ROW) return false;
    } while (!areSame(expected.get(), found.get()));
  return step == SQLITE_DONE;
}

/// Whether its tables are those of the kind and its pages do not contradict one another.
bool isSound(Database::Content& content, const FileKind& kind)
{
  return content.check(kind) && content.checkPages();
}

/// Whose a log is that lies beside a file which was not closed.
enum class LogOwner {
  file,    ///< All that lasts in the file is there with its log, too.
  others,  ///< The log of another file, or damaged.
  inUse,   ///< Another connection has both open: it has looked, or it writes them.
};

LogOwner ownerOfLog(const fs::path& place, const FileKind& kind, const std::stop_token& stop)
{
  Database::Content logged, alone;
  for (Database::Content* content : {&logged, &alone}) {
    content->file = place;
    content->watch->stop = stop;
    content->watch->maxInstructions = maxInstructionsFor(place);
  }
  if (!logged.open(place, Access::trial)) return LogOwner::file;
  const int begun = sqlite3_exec(logged.database.get(), "SELECT 1 FROM sqlite_master LIMIT 1",
                                 nullptr, nullptr, nullptr);
  if (begun == SQLITE_BUSY) return LogOwner::inUse;
  const bool isLoggedSound = isSound(logged, kind);
  const bool isAloneSound = alone.open(place, Access::immutable) && isSound(alone, kind);
  // A log that is merged in part leaves pages that contradict one another: then it is needed.
  if (!isAloneSound || !isLoggedSound)
    return isLoggedSound || !isAloneSound ? LogOwner::file : LogOwner::others;
  for (const std::string& query : kind.lasting) {
    logged.watch->instructions = alone.watch->instructions = 0;
    if (!hasRowsOf(logged.database.get(), alone.database.get(), query)) return LogOwner::others;
  }
  return LogOwner::file;
}

Result<Inspected> inspect(const fs::path& file, const FileKind& kind)
{
  const std::string name = file.string();
  std::error_code problem;
  if (fs::is_directory(file, problem)) return Error{"%1 is a folder. %2", name, kind.choice};
  if (!fs::exists(file, problem)) return Error{"%1 does not exist. Check the name.", name};
  if (!mayAccess(file, R_OK)) return Error{"%1 may not be read. Check its permissions.", name};

  Inspected inspected;
  inspected.place = fs::canonical(file, problem);
  if (problem) return Error{"%1 cannot be found: %2.", name, problem.message()};
  if (fs::is_regular_file(inspected.place, problem)) inspected.header = readHeader(inspected.place);
  if (!inspected.header.isDatabase) return Error{"%1 is not %2. %3", name, kind.name, kind.choice};
  const auto companions = companionsOf(inspected.place, inspected.header);
  if (!companions) return companions.error();
  inspected.companions = *companions;
  return inspected;
}

}  // namespace

Result<void> checkNoCompanions(const fs::path& file)
{
  for (const char* ending : {"-wal", "-journal"}) {
    const fs::path companion = file.string() + ending;
    std::error_code ignored;
    if (fs::exists(fs::symlink_status(companion, ignored)))
      return Error{
          "%1 belongs to a file that had the name %2 before, and would spoil a new one. Move it "
          "away, "
          "or choose another name.",
          companion, file.filename()};
  }
  return {};
}

Result<Database> Database::openNew(const fs::path& file)
{
  auto content = std::make_unique<Content>();
  content->file = file;
  std::error_code problem;
  const fs::path place = fs::canonical(file, problem);
  if (problem) return Error{problem.message()};
  if (const auto done = content->open(place, Access::write); !done) return done.error();
  return Database(std::move(content));
}

Result<Database> Database::openToAppend(const fs::path& file, const FileKind& kind)
{
  std::error_code ignored;
  if (fs::is_symlink(fs::symlink_status(file, ignored)))
    if (const auto refused = checkWritable(file, Links::refused); !refused) return refused.error();
  const auto inspected = inspect(file, kind);
  if (!inspected) return inspected.error();
  const std::string name = file.string();
  if (!mayWrite(inspected->place))
    return Error{"%1 may not be written. Check its permissions and those of its folder.", name};
  auto content = std::make_unique<Content>();
  content->file = file;
  content->remedy = kind.remedy;
  const auto& [place, header, companions] = *inspected;
  const bool mayHaveLog = companions.hasLog && !companions.hasForeignLog;
  if (!header.isWhole && !mayHaveLog) return content->error(Sentence{"it is cut short"});
  const auto isForeign = [&name](const fs::path& companion) {
    return Error{"%1 is not that of %2 and would spoil it. Move it to another folder.", companion,
                 name};
  };
  if (companions.hasForeignJournal) return isForeign(place.string() + "-journal");
  if (companions.hasForeignLog || (mayHaveLog && ownerOfLog(place, kind, {}) == LogOwner::others))
    return isForeign(place.string() + "-wal");
  if (const auto done = content->open(place, Access::write); !done)
    return content->error(done.error().message);
  Database database(std::move(content));
  // Taken at once, so that a second writer is refused before it has done any work.
  if (!database.run("PRAGMA locking_mode=EXCLUSIVE; BEGIN IMMEDIATE; COMMIT"))
    return Error{
        "%1 is in use: another program works on it, or it cannot be locked (%2). Wait until that "
        "program has ended.",
        name, database.lastError()};
  if (const auto done = database.content_->check(kind); !done) return done.error();
  return database;
}

Result<Database> Database::open(const fs::path& file, const FileKind& kind, std::stop_token stop)
{
  auto inspected = inspect(file, kind);
  if (!inspected) return inspected.error();
  const auto& [place, header, companions] = *inspected;
  const std::string name = file.string();

  auto content = std::make_unique<Content>();
  content->file = file;
  content->remedy = kind.remedy;
  content->watch->stop = std::move(stop);
  content->watch->maxInstructions = maxInstructionsFor(place);
  const bool mayHaveLog = companions.hasLog && !companions.hasForeignLog;
  if (!header.isWhole && !mayHaveLog) return content->error(Sentence{"it is cut short"});

  const bool isWritable = mayWrite(place);
  if (mayHaveLog && !isWritable)
    content->note = name +
                    " was not closed and lies where nothing may be written, so the ticks in its "
                    "-wal file are not read. Copy both files to a folder you may write to.";
  const auto read = [&, &target = place](Access access) -> Result<void> {
    content->watch->instructions = 0;
    if (const auto done = content->open(target, access); !done)
      return content->error(done.error().message);
    // One state for all queries, whoever writes meanwhile.
    if (access == Access::recovery)
      sqlite3_exec(content->database.get(), "BEGIN", nullptr, nullptr, nullptr);
    return content->check(kind);
  };
  // Without recovery nothing is written, not even a lock.
  const fs::path log = place.string() + "-wal";
  const bool mayReadLog = mayAccess(log, R_OK);
  const bool isLogged =
      header.usesLog && companions.isLogThere && !companions.hasForeignLog && mayReadLog;
  const LogOwner owner =
      isLogged && isWritable ? ownerOfLog(place, kind, content->watch->stop) : LogOwner::others;
  bool recovers = owner != LogOwner::others;
  content->isShared = owner == LogOwner::inUse;
  if (mayHaveLog && isWritable && !mayReadLog)
    content->note = log.string() +
                    " may not be read, so the ticks in it are missing. Check its "
                    "permissions.";
  else if (companions.hasForeignLog || (mayHaveLog && isWritable && !recovers))
    content->note = place.string() + "-wal is not the log of " + name +
                    ", or is damaged, and is not read: what " + name +
                    " holds itself is shown. Move it to another folder.";
  else if (companions.hasForeignJournal)
    content->note = place.string() + "-journal is not that of " + name +
                    " and is not read. Move it to another folder.";
  // SQLite would read the log up to the damage and then delete it.
  if (owner == LogOwner::file && companions.hasLog) {
    if (const auto damage = damageOf(log)) {
      const fs::path kept = log.string() + ".damaged";
      std::error_code problem;
      recovers = fs::copy_file(log, kept, fs::copy_options::skip_existing, problem) ||
                 (!problem && fs::exists(kept));
      content->note = log.string() + " is damaged at byte " + std::to_string(*damage) +
                      (recovers ? ": what was recorded after it cannot be read. It is kept as " +
                                      kept.filename().string() + "."
                                : " and is not read, because no copy of it can be kept. Make "
                                  "space on the disk, or copy both files to another one.");
    }
  }
  auto done = read(recovers ? Access::recovery : Access::immutable);
  // If the disk is too full for recovery, checkpointed content can still be read.
  if (!done && recovers && header.isWhole && !content->watch->wasStopped) {
    if (const auto again = read(Access::immutable); again) {
      done = again;
      content->note =
          name +
          " was not closed and cannot be recovered here, so the ticks in its -wal file are "
          "not read. Make space on the disk, or copy both files to another one.";
    }
  }
  if (!done) return done.error();
  return Database(std::move(content));
}

}  // namespace perilymph::database
