// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/session/Recording.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <functional>
#include <optional>
#include <span>
#include <thread>
#include <utility>
#include <variant>
#include <vector>

#include "perilymph/database/Database.h"
#include "perilymph/foundation/Unfinished.h"
#include "perilymph/session/Csv.h"
#include "recording/HighlightKeys.h"
#include "recording/RecordedFacts.h"
#include "recording/RecordingEvents.h"
#include "recording/RecordingFormat.h"
#include "recording/TickBlock.h"

namespace perilymph::session {

namespace {

namespace fs = std::filesystem;
using database::Database;
using database::Statement;

/// Why a file cannot be created under a name, by the error number.
Error cannotCreate(const fs::path& file, int reason)
{
  std::error_code ignored;
  const fs::path folder = file.has_parent_path() ? file.parent_path() : fs::path(".");
  if (fs::is_directory(file, ignored))
    return Error{"%1 is a folder; name a file to record into.", file};
  if (reason == EEXIST)
    return Error{
        "%1 exists already; a recording is never overwritten. Choose another name or move the file "
        "away.",
        file};
  if (!fs::is_directory(folder, ignored))
    return Error{"The folder %1 does not exist, so %2 cannot be recorded there. Create it first.",
                 folder, file.filename()};
  return Error{"%1 cannot be written: %2. Choose a folder you may write to.", file,
               std::strerror(reason)};
}

/// Identity of the file at a path; {0, 0} if there is none.
std::pair<dev_t, ino_t> inodeOf(const fs::path& file)
{
  struct stat found = {};
  if (::stat(file.c_str(), &found) != 0) return {0, 0};
  return {found.st_dev, found.st_ino};
}

}  // namespace

struct Recording::Content {
  fs::path file;
  std::pair<dev_t, ino_t> identity;
  std::optional<Database> database;
  std::optional<Statement> insertBlock, removeBlocks, insertEvent, setMeta;
  BlockPacker packer;
  bool isClosed = false;
  bool isEnded = false;   ///< Marked as closed; its log is not merged yet.
  bool isCut = false;     ///< A drain failed.
  bool isMerged = false;  ///< Closed as one file: a log beside it is not its own.

  MetaRows meta;                          ///< As in the file.
  std::vector<haptics::TickRecord> open;  ///< The newest ticks, in small blocks so far.
  Sha256 fullBlocks;                      ///< Hash of the blocks before these.
  Sha256 blocks;                          ///< Hash of all blocks.
  EventDetector events;
  Highlights highlights;

  Error cannotRecord(const std::string& reason) const
  {
    return Error{
        "%1 can no longer be recorded (%2). What is in it stays readable; make space on the disk "
        "and start a new recording.",
        file, reason};
  }
  bool isAtItsPlace() const { return inodeOf(file) == identity; }
  Error isGone() const
  {
    return Error{
        "%1 was moved or deleted while it was recorded, so nothing more is recorded. Start a new "
        "recording, and move recordings only after the insertion.",
        file};
  }

  bool keep(const char* key, const std::string& value)
  {
    setMeta->reset();
    setMeta->bind(0, std::string(key));
    setMeta->bind(1, value);
    meta[key] = value;
    return setMeta->step() == Statement::Step::done;
  }
  bool keepHash() { return keep(MetaKey::contentHash, sealOver(meta, blocks)); }

  /// Calls `each` for every prepared statement.
  template <class Each>
  void forEachStatement(const Each& each)
  {
    for (auto* statement : {&insertBlock, &removeBlocks, &insertEvent, &setMeta}) each(*statement);
  }
  void resetStatements()
  {
    forEachStatement([](auto& statement) { statement.reset(); });
  }

  bool addEvents(const haptics::TickRecord& record);
  bool addBlock(std::span<const haptics::TickRecord> records);
  bool addTicks(std::span<const haptics::TickRecord> records);
  bool fillBlock();
  bool keepHighlights();
  bool keepEnding(std::uint64_t lostRecords, const std::string& deviceReport);
  /// Runs `write` in one transaction, rolled back on failure.
  Result<void> transact(const std::function<bool()>& write);
  Result<void> prepare();
  Result<void> write(const fs::path& unfinished, const RecordingFacts& facts);
  Result<void> begin();
  Result<void> goOn();
  Result<void> end(std::uint64_t lostRecords, const std::string& deviceReport);
  void letGo();
  Result<bool> mergeLog();
};

bool Recording::Content::addEvents(const haptics::TickRecord& record)
{
  const std::vector<Event> found = events.add(record);
  return std::all_of(found.begin(), found.end(), [this](const Event& event) {
    insertEvent->reset();
    insertEvent->bind(0, static_cast<std::int64_t>(event.tick));
    insertEvent->bind(1, event.time);
    insertEvent->bind(2, event.kind);
    std::visit([this](const auto& value) { insertEvent->bind(3, value); }, event.value);
    return insertEvent->step() == Statement::Step::done;
  });
}

/// Adds one row with these ticks.
bool Recording::Content::addBlock(std::span<const haptics::TickRecord> records)
{
  const auto firstTick = static_cast<std::int64_t>(records.front().tick);
  const auto ticks = static_cast<std::int64_t>(records.size());
  const std::span<const unsigned char> packed = packer.pack(records);
  if (packed.empty()) return false;
  insertBlock->reset();
  insertBlock->bind(0, firstTick);
  insertBlock->bind(1, ticks);
  insertBlock->bind(2, packed);
  session::addBlock(blocks, firstTick, ticks, packed);
  return insertBlock->step() == Statement::Step::done;
}

/// Replaces the small blocks by one.
bool Recording::Content::fillBlock()
{
  if (open.empty()) return true;
  removeBlocks->reset();
  removeBlocks->bind(0, static_cast<std::int64_t>(open.front().tick));
  if (removeBlocks->step() != Statement::Step::done) return false;
  blocks = fullBlocks;
  if (!addBlock(open)) return false;
  fullBlocks = blocks;
  open.clear();
  return true;
}

bool Recording::Content::addTicks(std::span<const haptics::TickRecord> records)
{
  while (!records.empty()) {
    const auto now = records.first(std::min(records.size(), blockTicks - open.size()));
    records = records.subspan(now.size());
    open.insert(open.end(), now.begin(), now.end());
    if (!(open.size() == blockTicks ? fillBlock() : addBlock(now))) return false;
    if (!std::all_of(now.begin(), now.end(), [this](const auto& tick) { return addEvents(tick); }))
      return false;
  }
  return true;
}

bool Recording::Content::keepHighlights()
{
  if (!keep(MetaKey::ticks, std::to_string(highlights.ticks)) ||
      !keep(highlightEnd, haptics::nameOf(highlights.end)))
    return false;
  return std::all_of(highlightKeys.begin(), highlightKeys.end(), [this](const auto& entry) {
    return keep(entry.first, shortestDecimal(highlights.*entry.second));
  });
}

bool Recording::Content::keepEnding(std::uint64_t lostRecords, const std::string& deviceReport)
{
  return fillBlock() &&
         keep(MetaKey::lostRecords, std::to_string(std::max(lostRecords, events.missingTicks()))) &&
         (deviceReport.empty() || keep(MetaKey::deviceReport, deviceReport)) && keepHighlights() &&
         keep(MetaKey::closed, "1") && keepHash();
}

Result<void> Recording::Content::transact(const std::function<bool()>& write)
{
  if (const auto done = database->run("BEGIN"); !done) return done.error();
  const bool isWritten = write();
  std::string reason = isWritten ? "" : database->lastError();
  forEachStatement([](auto& statement) { statement->reset(); });
  if (isWritten) {
    const auto done = database->run("COMMIT");
    if (done) return {};
    reason = done.error().message;
  }
  static_cast<void>(database->run("ROLLBACK"));
  return Error{reason};
}

/// Prepares what every drain runs.
Result<void> Recording::Content::prepare()
{
  const std::pair<std::optional<Statement>&, std::string> statements[] = {
      {insertBlock, "INSERT INTO block VALUES(?,?,?)"},
      {removeBlocks, "DELETE FROM block WHERE tick >= ?"},
      {insertEvent, "INSERT INTO event VALUES(?,?,?,?)"},
      {setMeta, "INSERT OR REPLACE INTO meta VALUES(?,?)"}};
  for (const auto& [statement, sql] : statements) {
    auto prepared = database->prepare(sql);
    if (!prepared) return prepared.error();
    statement = std::move(*prepared);
  }
  return {};
}

/// Writes tables and metadata.
Result<void> Recording::Content::write(const fs::path& unfinished, const RecordingFacts& facts)
{
  auto opened = Database::openNew(unfinished);
  if (!opened) return opened.error();
  database = std::move(*opened);
  if (const auto done = database->run(creationOf(recordingKind())); !done) return done.error();
  if (const auto done = prepare(); !done) return done;
  const MetaRows rows = metaRowsOf(facts);
  const bool isKept =
      std::all_of(rows.begin(), rows.end(),
                  [this](const auto& row) { return keep(row.first.c_str(), row.second); }) &&
      keepHash();
  setMeta->reset();
  if (!isKept) return Error{database->lastError()};
  if (const auto done = database->run("COMMIT"); !done) return done.error();
  resetStatements();
  database.reset();
  return {};
}

/// Begins the log of a file with tables and metadata: a copy of the file without its `-wal` is a
/// valid recording.
Result<void> Recording::Content::begin()
{
  auto opened = Database::openNew(file);
  if (!opened) return opened.error();
  database = std::move(*opened);
  if (const auto done = prepare(); !done) return done;
  // After a commit the data are with the operating system and survive the end of the process;
  // waiting for the disk at every drain would only protect against a power failure.
  // Small blocks that a full one replaces need not be overwritten with zeros: it holds the same.
  return database->run(
      "PRAGMA journal_mode=WAL; PRAGMA synchronous=NORMAL; PRAGMA secure_delete=OFF");
}

/// Opens a closed recording again.
Result<void> Recording::Content::goOn()
{
  if (isCut) return cannotRecord("it is closed");
  if (!isAtItsPlace()) return isGone();
  if (isMerged)
    if (const auto alone = database::checkNoCompanions(file); !alone) return alone.error();
  auto done = begin();
  isMerged = false;
  if (done) done = transact([this] { return keep(MetaKey::closed, "0") && keepHash(); });
  isClosed = !done;
  if (!done) return cannotRecord(done.error().message);
  return {};
}

Recording::Recording() : content_(std::make_unique<Content>()) {}

Recording::~Recording()
{
  if (!content_->isClosed) static_cast<void>(close());
}

Result<std::unique_ptr<Recording>> Recording::create(const fs::path& file,
                                                     const RecordingFacts& facts)
{
  std::error_code ignored;
  if (fs::exists(fs::symlink_status(file, ignored))) return cannotCreate(file, EEXIST);
  if (const auto done = database::checkNoCompanions(file); !done) return done.error();
  // Under its name it is whole, whenever the process is killed.
  const fs::path unfinished = unfinishedPath(file);
  const int descriptor =
      ::open(unfinished.c_str(), O_CREAT | O_EXCL | O_WRONLY | O_NOFOLLOW | O_CLOEXEC, 0600);
  if (descriptor < 0) return cannotCreate(file, errno);
  ::close(descriptor);
  std::unique_ptr<Recording> recording(new Recording);
  Content& content = *recording->content_;
  content.file = file;
  content.isClosed = true;  // until it has begun

  auto begun = content.write(unfinished, facts);
  const int problem = begun ? giveNewName(unfinished, file) : 0;
  const bool isNamed = begun && problem == 0;
  content.identity = inodeOf(file);
  if (isNamed) begun = content.begin();
  if (begun && isNamed) {
    content.isClosed = false;
    return recording;
  }
  recording.reset();
  for (const char* ending : {"", "-wal", "-shm", "-journal"})
    fs::remove((isNamed ? file : unfinished).string() + ending, ignored);
  if (problem != 0) return cannotCreate(file, problem);
  return Error{"%1 cannot be begun: %2. Is there space on the disk?", file, begun.error().message};
}

Result<void> Recording::append(std::span<const haptics::TickRecord> records)
{
  if (records.empty()) return {};
  Content& content = *content_;
  if (content.isClosed)
    if (auto again = content.goOn(); !again) return again;
  const auto done = content.transact([&] {
    return (!content.isEnded || content.keep(MetaKey::closed, "0")) && content.addTicks(records) &&
           content.keepHash();
  });
  if (done) content.isEnded = false;
  const bool isGone = !content.isAtItsPlace();
  content.isCut = !done || isGone;
  if (!done && !isGone) return content.cannotRecord(done.error().message);
  if (isGone) return content.isGone();
  for (const haptics::TickRecord& record : records) content.highlights.add(record);
  return {};
}

/// Marks the recording as closed. One that is incomplete never is, even if there is space to do so.
Result<void> Recording::Content::end(std::uint64_t lostRecords, const std::string& deviceReport)
{
  const bool isInPlace = isAtItsPlace();
  Result<void> done;
  if (!isCut && isInPlace) done = transact([&] { return keepEnding(lostRecords, deviceReport); });
  isEnded = isInPlace && done;
  isClosed = !isEnded;
  if (!isInPlace) {
    resetStatements();
    database->abandon();
    return isGone();
  }
  if (!done) return cannotRecord(done.error().message);
  return {};
}

/// Closes the file.
void Recording::Content::letGo()
{
  resetStatements();
  database.reset();
  isClosed = true;
  isEnded = false;
}

/// Leaves WAL mode, which merges the log into the file and removes it.
///
/// @return  False while the file has readers; nothing is lost, and the log stays.
Result<bool> Recording::Content::mergeLog()
{
  const auto done = database->run("PRAGMA journal_mode=DELETE");
  if (!done && database->isBusy()) return false;
  letGo();
  isMerged = static_cast<bool>(done);
  if (!done) return cannotRecord(done.error().message);
  return true;
}

Result<bool> Recording::conclude(std::uint64_t lostRecords)
{
  Content& content = *content_;
  if (content.isClosed) return true;
  if (!content.isEnded)
    if (auto ended = content.end(lostRecords, {}); !ended) return ended.error();
  return content.mergeLog();
}

Result<void> Recording::close(std::uint64_t lostRecords, const std::string& deviceReport)
{
  Content& content = *content_;
  // what a device did is known only when the loop has ended
  const bool isNews = content.isClosed && !content.isCut && !deviceReport.empty();
  if (isNews)
    if (auto again = content.goOn(); !again) return again;
  if (content.isClosed) return {};
  if (auto ended = content.end(lostRecords, deviceReport); !ended) return ended;
  constexpr int attempts = 100;
  for (int i = 0; i < attempts; ++i) {
    const auto merged = content.mergeLog();
    if (!merged) return merged.error();
    if (*merged) return {};
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  content.letGo();
  return Error{
      "%1 is complete, but in several files, because another program reads it. Close that program; "
      "the recording is one file when it has been opened once more.",
      content.file};
}

const fs::path& Recording::file() const noexcept { return content_->file; }

}  // namespace perilymph::session
