#include "perilymph/session/Recording.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <optional>
#include <utility>
#include <vector>

#include "Database.h"
#include "HighlightKeys.h"
#include "RecordingFormat.h"
#include "TickBlob.h"
#include "perilymph/session/Csv.h"

namespace perilymph::session {

namespace {

namespace fs = std::filesystem;

/// Claims the name of a new file, so that two recordings never meet in one.
Result<Done> claim(const fs::path& file)
{
  const int descriptor = ::open(file.c_str(), O_CREAT | O_EXCL | O_WRONLY | O_CLOEXEC, 0644);
  if (descriptor >= 0) {
    ::close(descriptor);
    return Done{};
  }
  const int reason = errno;
  std::error_code ignored;
  const fs::path folder = file.has_parent_path() ? file.parent_path() : fs::path(".");
  if (fs::is_directory(file, ignored))
    return Error{file.string() + " is a folder; name a file to record into."};
  if (reason == EEXIST)
    return Error{file.string() +
                 " exists already; a recording is never overwritten. Choose another name or "
                 "move the file away."};
  if (!fs::is_directory(folder, ignored))
    return Error{"The folder " + folder.string() + " does not exist, so " +
                 file.filename().string() + " cannot be recorded there. Create it first."};
  return Error{file.string() + " cannot be written: " + std::strerror(reason) +
               ". Choose a folder you may write to."};
}

std::string createTables()
{
  std::string columns;
  for (const char* name : columnNames) columns += std::string(", ") + name + " REAL";
  return "CREATE TABLE meta(key TEXT PRIMARY KEY, value TEXT NOT NULL);"
         "CREATE TABLE tick(tick INTEGER PRIMARY KEY" +
         columns +
         ", record BLOB NOT NULL);"
         "CREATE TABLE event(tick INTEGER NOT NULL, time_s REAL, kind TEXT NOT NULL, value);";
}

std::string insertTick()
{
  std::string values = "INSERT INTO tick VALUES(?";
  for (int i = 0; i < columnCount; ++i) values += ",?";
  return values + ",?)";
}

std::string commandWord(haptics::Command::Kind kind)
{
  using Kind = haptics::Command::Kind;
  switch (kind) {
    case Kind::none:
      return "none";
    case Kind::arm:
      return "arm";
    case Kind::reset:
      return "reset";
    case Kind::withdraw:
      return "withdraw";
    case Kind::pullStylet:
      return "pullStylet";
    case Kind::setForceScale:
      return "setForceScale";
    case Kind::clearFault:
      return "clearFault";
    case Kind::requestFault:
      return "requestFault";
  }
  return "command " + std::to_string(static_cast<std::uint32_t>(kind));
}

}  // namespace

std::string workflowWord(haptics::Workflow workflow)
{
  constexpr std::array<const char*, 6> words = {"idle",   "armed",    "inserting",
                                                "paused", "finished", "fault"};
  const auto number = static_cast<std::uint32_t>(workflow);
  return number < words.size() ? words[number] : "workflow " + std::to_string(number);
}

std::string statusWords(std::uint32_t status)
{
  constexpr std::array<std::pair<haptics::Status, const char*>, 12> words = {
      {{haptics::staleSample, "staleSample"},
       {haptics::couplingSoftened, "couplingSoftened"},
       {haptics::nearWorkspaceEnd, "nearWorkspaceEnd"},
       {haptics::forceClamped, "forceClamped"},
       {haptics::forceSlewed, "forceSlewed"},
       {haptics::rampingIn, "rampingIn"},
       {haptics::notFinite, "notFinite"},
       {haptics::passivityActed, "passivityActed"},
       {haptics::notSettled, "notSettled"},
       {haptics::deviceLost, "deviceLost"},
       {haptics::sampleDoubted, "sampleDoubted"},
       {haptics::handJumped, "handJumped"}}};
  std::string text;
  for (const auto& [bit, word] : words)
    if (status & bit) text += (text.empty() ? "" : " ") + std::string(word);
  return text;
}

struct Recording::Content {
  fs::path file;
  Database database;
  std::optional<Statement> insertTick, insertEvent, setMeta;
  std::vector<unsigned char> blob;
  bool isClosed = false;
  bool isCut = false;  ///< A drain could not be kept.

  // What the last tick was like: events are changes.
  std::optional<std::uint64_t> lastTick;
  haptics::Workflow workflow = haptics::Workflow::idle;
  std::uint32_t status = haptics::allWell;
  std::uint64_t gaps = 0;
  Highlights highlights;

  Result<Done> trouble(const std::string& what) const
  {
    return Error{
        file.string() + " can no longer be recorded (" + what +
        "). What is in it stays readable; make room on the disk and start a new recording."};
  }

  bool keep(const char* key, const std::string& value)
  {
    setMeta->reset();
    setMeta->bind(0, std::string(key));
    setMeta->bind(1, value);
    return setMeta->step() == Statement::Step::done;
  }

  template <class Value>
  bool addEvent(const haptics::TickRecord& record, const std::string& kind, const Value& value)
  {
    insertEvent->reset();
    insertEvent->bind(0, static_cast<std::int64_t>(record.tick));
    insertEvent->bind(1, record.output.time);
    insertEvent->bind(2, kind);
    insertEvent->bind(3, value);
    return insertEvent->step() == Statement::Step::done;
  }

  bool addEvents(const haptics::TickRecord& record);
  bool addTick(const haptics::TickRecord& record);
  bool keepHighlights();
  Result<Done> begin(const RecordingFacts& facts);
};

bool Recording::Content::addEvents(const haptics::TickRecord& record)
{
  const std::uint64_t expected = lastTick ? *lastTick + 1 : record.tick;
  if (record.tick > expected) {
    const std::uint64_t missing = record.tick - expected;
    if (!addEvent(record, "lost", static_cast<std::int64_t>(missing))) return false;
    gaps += missing;
  }
  lastTick = record.tick;
  for (std::uint32_t i = 0; i < record.commands.count && i < haptics::maxCommandsPerTick; ++i) {
    const haptics::Command& command = record.commands.items[i];
    if (!addEvent(record, commandWord(command.kind), command.value)) return false;
  }
  if (record.output.workflow != workflow) {
    workflow = record.output.workflow;
    if (!addEvent(record, "workflow", workflowWord(workflow))) return false;
  }
  // Of the status only what appears; that it went away is in the ticks.
  const std::uint32_t appeared = record.output.status & ~status;
  status = record.output.status;
  return appeared == 0 || addEvent(record, "status", statusWords(appeared));
}

bool Recording::Content::addTick(const haptics::TickRecord& record)
{
  insertTick->reset();
  insertTick->bind(0, static_cast<std::int64_t>(record.tick));
  int parameter = 1;
  for (const double value : columnValues(record)) insertTick->bind(parameter++, value);
  writeTick(record, blob);
  insertTick->bind(parameter, std::span<const unsigned char>(blob));
  return insertTick->step() == Statement::Step::done && addEvents(record);
}

bool Recording::Content::keepHighlights()
{
  if (!keep(MetaKey::ticks, std::to_string(highlights.ticks))) return false;
  return std::all_of(highlightKeys.begin(), highlightKeys.end(), [this](const auto& entry) {
    return keep(entry.first, shortestDecimal(highlights.*entry.second));
  });
}

Result<Done> Recording::Content::begin(const RecordingFacts& facts)
{
  // Tables and facts go into the file itself before the log begins, so that a copy without its
  // `-wal` is a recording, too.
  if (const auto done =
          database.run("PRAGMA application_id=" + std::to_string(recordingApplicationId) +
                       "; PRAGMA user_version=" + std::to_string(newestRecordingVersion) +
                       "; BEGIN;" + createTables());
      !done)
    return done.error();

  const std::pair<std::optional<Statement>&, std::string> statements[] = {
      {insertTick, session::insertTick()},
      {insertEvent, "INSERT INTO event VALUES(?,?,?,?)"},
      {setMeta, "INSERT OR REPLACE INTO meta VALUES(?,?)"}};
  for (const auto& [statement, sql] : statements) {
    auto prepared = database.prepare(sql);
    if (!prepared) return prepared.error();
    statement = std::move(*prepared);
  }
  const bool isKept =
      keep(MetaKey::scenarioName, facts.scenarioName) &&
      keep(MetaKey::scenario, facts.scenarioText) && keep(MetaKey::device, facts.device) &&
      keep(MetaKey::timeStep, shortestDecimal(facts.timeStep)) &&
      keep(MetaKey::samplePeriod, shortestDecimal(facts.samplePeriod)) &&
      keep(MetaKey::mostForce, shortestDecimal(facts.mostForce)) &&
      keep(MetaKey::offTime, shortestDecimal(facts.offTime)) &&
      keep(MetaKey::reach, shortestDecimal(facts.reach)) &&
      keep(MetaKey::feelsForce, facts.feelsForce ? "1" : "0") &&
      keep(MetaKey::mostStiffness, shortestDecimal(facts.mostStiffness)) &&
      keep(MetaKey::mostDamping, shortestDecimal(facts.mostDamping)) &&
      keep(MetaKey::deviceDelay, shortestDecimal(facts.deviceDelay)) &&
      keep(MetaKey::seed, std::to_string(facts.seed)) &&
      keep(MetaKey::modelFingerprint, std::to_string(facts.modelFingerprint)) &&
      keep(MetaKey::version, facts.version) && keep(MetaKey::buildId, facts.buildId) &&
      keep(MetaKey::startedUtc, facts.startedUtc) && keep(MetaKey::lostRecords, "0") &&
      keep(MetaKey::closed, "0");
  setMeta->reset();
  if (!isKept) return Error{database.trouble()};
  if (const auto done = database.run("COMMIT"); !done) return done.error();

  // A commit is in the hands of the system when it returns (the end of the process loses nothing);
  // waiting for the disk as well, at every drain, would only guard against a loss of power.
  return database.run("PRAGMA journal_mode=WAL; PRAGMA synchronous=NORMAL");
}

Recording::Recording() : content_(std::make_unique<Content>()) {}

Recording::~Recording()
{
  if (!content_->isClosed) static_cast<void>(close());
}

Result<std::unique_ptr<Recording>> Recording::create(const fs::path& file,
                                                     const RecordingFacts& facts)
{
  if (const auto done = claim(file); !done) return done.error();
  std::unique_ptr<Recording> recording(new Recording);
  Content& content = *recording->content_;
  content.file = file;
  content.isClosed = true;  // until it is begun

  const auto begun = [&]() -> Result<Done> {
    auto database = Database::open(file, Database::Access::readWrite);
    if (!database) return database.error();
    content.database = std::move(*database);
    return content.begin(facts);
  }();
  if (!begun) {
    recording.reset();
    for (const char* ending : {"", "-wal", "-shm", "-journal"}) {
      std::error_code ignored;
      fs::remove(file.string() + ending, ignored);
    }
    return Error{file.string() + " cannot be begun: " + begun.error().message +
                 ". Is there room on the disk?"};
  }
  content.isClosed = false;
  return recording;
}

Result<Done> Recording::append(std::span<const haptics::TickRecord> records)
{
  if (records.empty()) return Done{};
  Content& content = *content_;
  if (content.isClosed) return content.trouble("it is closed");
  if (const auto done = content.database.run("BEGIN"); !done) {
    content.isCut = true;
    return content.trouble(done.error().message);
  }
  const bool isWritten = std::all_of(records.begin(), records.end(),
                                     [&](const auto& record) { return content.addTick(record); });
  std::string reason = isWritten ? "" : content.database.trouble();
  content.insertTick->reset();
  content.insertEvent->reset();
  if (isWritten) {
    const auto done = content.database.run("COMMIT");
    if (done) {
      for (const haptics::TickRecord& record : records) content.highlights.add(record);
      return Done{};
    }
    reason = done.error().message;
  }
  static_cast<void>(content.database.run("ROLLBACK"));
  content.isCut = true;
  return content.trouble(reason);
}

Result<Done> Recording::close(std::uint64_t lostRecords, const std::string& deviceReport)
{
  Content& content = *content_;
  if (content.isClosed) return Done{};
  content.isClosed = true;
  // One that was cut off never says that it was closed, even where there is room for the word.
  const bool isKept =
      content.isCut ||
      (content.keep(MetaKey::lostRecords, std::to_string(std::max(lostRecords, content.gaps))) &&
       (deviceReport.empty() || content.keep(MetaKey::deviceReport, deviceReport)) &&
       content.keepHighlights() && content.keep(MetaKey::closed, "1"));
  const std::string reason = isKept ? "" : content.database.trouble();
  content.insertTick.reset();
  content.insertEvent.reset();
  content.setMeta.reset();
  if (!isKept) return content.trouble(reason);
  // Leaving the log folds it into the file and removes it.
  const auto done = content.database.run("PRAGMA journal_mode=DELETE");
  content.database = Database();
  if (!done)
    return Error{content.file.string() + " stays in several files: " + done.error().message +
                 ". Close the other program that reads it, then open the recording once."};
  return Done{};
}

const fs::path& Recording::file() const noexcept { return content_->file; }

}  // namespace perilymph::session
