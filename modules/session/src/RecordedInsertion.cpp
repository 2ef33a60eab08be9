#include "perilymph/session/RecordedInsertion.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <fstream>
#include <map>
#include <optional>

#include "Companions.h"
#include "Database.h"
#include "HighlightKeys.h"
#include "RecordingFormat.h"
#include "TickBlob.h"

namespace perilymph::session {

namespace {

namespace fs = std::filesystem;

/// What the first bytes of a file say.
struct FileHeader {
  bool isDatabase = false;
  bool isWhole = true;  ///< As long as it says.
};

std::uint64_t bigEndian(const std::array<unsigned char, 100>& bytes, std::size_t first,
                        std::size_t count)
{
  std::uint64_t value = 0;
  for (std::size_t i = 0; i < count; ++i) value = value << 8 | bytes[first + i];
  return value;
}

/// Reads SQLite's header of 100 bytes (its file format, section 1.3).
FileHeader readHeader(const fs::path& file)
{
  std::array<unsigned char, 100> bytes{};
  std::ifstream stream(file, std::ios::binary);
  stream.read(reinterpret_cast<char*>(bytes.data()), bytes.size());
  constexpr std::string_view magic("SQLite format 3\0", 16);
  FileHeader header;
  const auto got = static_cast<std::size_t>(stream.gcount());
  header.isDatabase =
      got >= magic.size() &&
      std::string_view(reinterpret_cast<const char*>(bytes.data()), magic.size()) == magic;
  if (!header.isDatabase) return header;
  if (got < bytes.size()) {
    header.isWhole = false;
    return header;
  }
  const std::uint64_t pageField = bigEndian(bytes, 16, 2);
  const std::uint64_t pageSize = pageField == 1 ? 65536 : pageField;
  const std::uint64_t pages = bigEndian(bytes, 28, 4);
  std::error_code ignored;
  header.isWhole = fs::file_size(file, ignored) >= pages * pageSize;
  return header;
}

/// With the rights this process acts with, not those it was started with.
bool mayAccess(const fs::path& place, int mode)
{
  return ::faccessat(AT_FDCWD, place.c_str(), mode, AT_EACCESS) == 0;
}

bool mayWrite(const fs::path& file)
{
  const fs::path folder = file.has_parent_path() ? file.parent_path() : fs::path(".");
  return mayAccess(file, W_OK) && mayAccess(folder, W_OK);
}

template <class Number>
std::optional<Number> numberIn(const std::map<std::string, std::string>& facts, const char* key)
{
  const auto found = facts.find(key);
  if (found == facts.end()) return std::nullopt;
  const std::string& text = found->second;
  Number number{};
  const auto read = std::from_chars(text.data(), text.data() + text.size(), number);
  if (read.ec != std::errc() || read.ptr != text.data() + text.size()) return std::nullopt;
  return number;
}

/// Nothing if a fact is missing or is not what it must be.
std::optional<RecordingFacts> factsFrom(const std::map<std::string, std::string>& entries)
{
  RecordingFacts facts;
  const std::pair<const char*, std::string*> texts[] = {
      {MetaKey::scenarioName, &facts.scenarioName},
      {MetaKey::scenario, &facts.scenarioText},
      {MetaKey::device, &facts.device},
      {MetaKey::version, &facts.version},
      {MetaKey::buildId, &facts.buildId},
      {MetaKey::startedUtc, &facts.startedUtc}};
  for (const auto& [key, text] : texts) {
    const auto found = entries.find(key);
    if (found == entries.end()) return std::nullopt;
    *text = found->second;
  }
  const auto timeStep = numberIn<double>(entries, MetaKey::timeStep);
  const auto samplePeriod = numberIn<double>(entries, MetaKey::samplePeriod);
  const auto mostForce = numberIn<double>(entries, MetaKey::mostForce);
  const auto seed = numberIn<long>(entries, MetaKey::seed);
  const auto fingerprint = numberIn<std::uint64_t>(entries, MetaKey::modelFingerprint);
  if (!timeStep || !samplePeriod || !mostForce || !seed || !fingerprint) return std::nullopt;
  facts.timeStep = *timeStep;
  facts.samplePeriod = *samplePeriod;
  facts.mostForce = *mostForce;
  // Recordings from before hands felt forces do not have these.
  // Recorded before there was one: a force that was switched off went as slowly as any other.
  facts.offTime = numberIn<double>(entries, MetaKey::offTime).value_or(0.0);
  facts.reach = numberIn<double>(entries, MetaKey::reach).value_or(facts.reach);
  facts.feelsForce = numberIn<int>(entries, MetaKey::feelsForce).value_or(0) != 0;
  facts.mostStiffness =
      numberIn<double>(entries, MetaKey::mostStiffness).value_or(facts.mostStiffness);
  facts.mostDamping = numberIn<double>(entries, MetaKey::mostDamping).value_or(facts.mostDamping);
  facts.deviceDelay = numberIn<double>(entries, MetaKey::deviceDelay).value_or(facts.deviceDelay);
  facts.seed = *seed;
  facts.modelFingerprint = *fingerprint;
  return facts;
}

/// Nothing in recordings from before they were noted.
std::optional<Highlights> notedHighlights(const std::map<std::string, std::string>& entries)
{
  Highlights noted;
  const auto ticks = numberIn<std::uint64_t>(entries, MetaKey::ticks);
  if (!ticks) return std::nullopt;
  noted.ticks = *ticks;
  for (const auto& [key, field] : highlightKeys) {
    const auto number = numberIn<double>(entries, key);
    if (!number) return std::nullopt;
    noted.*field = *number;
  }
  return noted;
}

}  // namespace

struct RecordedInsertion::Content {
  fs::path file;
  Database database;
  RecordingFacts facts;
  bool wasClosed = false;
  std::uint64_t lostRecords = 0;
  std::optional<Highlights> highlights;  ///< As noted in the file.
  std::string note;

  Error damaged(const std::string& reason) const
  {
    return Error{file.string() + " is damaged (" + reason +
                 "). Use another copy of the recording."};
  }
  Error notOurs() const
  {
    return Error{file.string() + " is not a recording of Perilymph. Choose an .insertion file."};
  }

  Result<Done> read(const fs::path& place, Database::Access access);
  Result<Done> readFacts();
};

Result<Done> RecordedInsertion::Content::read(const fs::path& place, Database::Access access)
{
  auto opened = Database::open(place, access);
  if (!opened) return damaged(opened.error().message);
  database = std::move(*opened);
  return readFacts();
}

Result<Done> RecordedInsertion::Content::readFacts()
{
  const std::int64_t application = database.number("PRAGMA application_id");
  if (database.isDamaged()) return damaged(database.trouble());
  if (application != recordingApplicationId) return notOurs();
  const std::int64_t version = database.number("PRAGMA user_version");
  if (version > newestRecordingVersion)
    return Error{file.string() + " was recorded with format " + std::to_string(version) +
                 "; this program reads up to " + std::to_string(newestRecordingVersion) +
                 ". Open it with a newer version."};

  // Something by these names that computes what it holds could compute for ever.
  if (database.number("SELECT COUNT(*) FROM sqlite_master WHERE lower(name) IN "
                      "('meta', 'tick', 'event') AND NOT (type = 'table' AND rootpage > 0)") != 0)
    return damaged("its tables are none");

  auto rows = database.prepare("SELECT key, value FROM meta");
  if (!rows) return damaged(rows.error().message);
  std::map<std::string, std::string> entries;
  Statement::Step step = rows->step();
  for (; step == Statement::Step::row; step = rows->step()) entries[rows->text(0)] = rows->text(1);
  if (step == Statement::Step::failed) return damaged(database.trouble());

  const auto read = factsFrom(entries);
  if (!read) return damaged("facts about it are missing");
  facts = *read;
  wasClosed = entries[MetaKey::closed] == "1";
  if (wasClosed) highlights = notedHighlights(entries);
  lostRecords = numberIn<std::uint64_t>(entries, MetaKey::lostRecords).value_or(0);
  // One that was not closed has not summed up its losses yet.
  const auto gaps =
      database.number("SELECT COALESCE(SUM(value), 0) FROM event WHERE kind = 'lost'");
  lostRecords = std::max(lostRecords, static_cast<std::uint64_t>(std::max<std::int64_t>(gaps, 0)));
  return Done{};
}

RecordedInsertion::RecordedInsertion() : content_(std::make_unique<Content>()) {}
RecordedInsertion::RecordedInsertion(RecordedInsertion&&) noexcept = default;
RecordedInsertion& RecordedInsertion::operator=(RecordedInsertion&&) noexcept = default;
RecordedInsertion::~RecordedInsertion() = default;

Result<RecordedInsertion> RecordedInsertion::open(const fs::path& file)
{
  RecordedInsertion opened;
  Content& content = *opened.content_;
  content.file = file;

  std::error_code problem;
  if (fs::is_directory(file, problem))
    return Error{file.string() + " is a folder. Choose an .insertion file."};
  if (!fs::exists(file, problem))
    return Error{file.string() + " does not exist. Check the name of the recording."};
  if (!mayAccess(file, R_OK))
    return Error{file.string() + " may not be read. Check its permissions."};

  // Where a link points, there lies what belongs to the recording.
  const fs::path place = fs::canonical(file, problem);
  if (problem) return Error{file.string() + " cannot be found: " + problem.message() + "."};
  if (!fs::is_regular_file(place, problem)) return content.notOurs();
  const FileHeader header = readHeader(place);
  if (!header.isDatabase) return content.notOurs();
  const auto companions = companionsOf(place);
  if (!companions) return companions.error();
  if (!header.isWhole && !companions->hasLog) return content.damaged("it is cut short");

  const bool isWritable = mayWrite(place);
  if (companions->hasLog && !isWritable)
    content.note = file.string() +
                   " was not closed and lies where nothing may be written, so the ticks in its "
                   "-wal file are not read. Copy both files to a folder you may write to.";
  // With nothing to recover nothing is written, not even a lock.
  const bool recovers = isWritable && companions->areToRead;
  const auto read =
      content.read(place, recovers ? Database::Access::readWrite : Database::Access::immutable);
  if (read) return opened;
  // Where a full disk has no room for recovering, what was folded into the file is there still.
  if (!recovers || !header.isWhole || !content.read(place, Database::Access::immutable))
    return read.error();
  content.note = file.string() +
                 " was not closed and cannot be recovered here, so the ticks in its -wal file are "
                 "not read. Make room on the disk, or copy both files to another one.";
  return opened;
}

const RecordingFacts& RecordedInsertion::facts() const noexcept { return content_->facts; }

std::uint64_t RecordedInsertion::ticks() const
{
  return static_cast<std::uint64_t>(content_->database.number("SELECT COUNT(*) FROM tick"));
}

std::uint64_t RecordedInsertion::lostRecords() const { return content_->lostRecords; }

bool RecordedInsertion::wasClosed() const noexcept { return content_->wasClosed; }

const std::string& RecordedInsertion::note() const noexcept { return content_->note; }

Result<Highlights> RecordedInsertion::highlights() const
{
  if (content_->highlights) return *content_->highlights;
  Highlights found;
  const auto read = forEach([&found](const haptics::TickRecord& record) {
    found.add(record);
    return true;
  });
  if (!read) return read.error();
  return found;
}

Result<Done> RecordedInsertion::forEach(const std::function<bool(const haptics::TickRecord&)>& each,
                                        std::uint64_t firstTick) const
{
  auto rows =
      content_->database.prepare("SELECT tick, record FROM tick WHERE tick >= ? ORDER BY tick");
  if (!rows) return content_->damaged(rows.error().message);
  rows->bind(0, static_cast<std::int64_t>(firstTick));
  Statement::Step step = rows->step();
  for (; step == Statement::Step::row; step = rows->step()) {
    const auto record = readTick(rows->blob(1));
    if (!record || record->tick != static_cast<std::uint64_t>(rows->integer(0)))
      return content_->damaged("the record of tick " + std::to_string(rows->integer(0)) +
                               " cannot be read");
    if (!each(*record)) return Done{};
  }
  if (step == Statement::Step::failed) return content_->damaged(content_->database.trouble());
  return Done{};
}

}  // namespace perilymph::session
