// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/session/RecordedInsertion.h"

#include <algorithm>
#include <limits>
#include <stop_token>

#include "perilymph/foundation/RenamedKeys.h"
#include "perilymph/session/Csv.h"
#include "recording/RecordedContent.h"
#include "recording/TickBlob.h"
#include "recording/TickBlock.h"

namespace perilymph::session {

namespace {

namespace fs = std::filesystem;
using database::Database;
using database::Statement;

constexpr std::size_t maxMetaRows = 100;
constexpr std::size_t maxMetaBytes = std::size_t{4} << 20;

std::string selectTicks()
{
  std::string columns = "tick, record";
  for (const char* name : recordedNames) columns += std::string(", ") + name;
  return "SELECT " + columns + " FROM tick WHERE tick >= ? ORDER BY tick";
}

/// The key of a table of ticks: SQLite's keys are signed.
std::int64_t keyOf(std::uint64_t tick)
{
  return static_cast<std::int64_t>(
      std::min<std::uint64_t>(tick, std::numeric_limits<std::int64_t>::max()));
}

}  // namespace

Result<void> RecordedInsertion::Content::forEachRising(
    const std::string& sql, std::int64_t firstKey,
    const std::function<Result<bool>(const Statement&)>& each) const
{
  auto rows = database.prepare(sql);
  if (!rows) return damaged(rows.error().message);
  rows->bind(0, firstKey);
  std::optional<std::int64_t> last;
  Statement::Step step = rows->step();
  for (; step == Statement::Step::row; step = rows->step()) {
    const std::int64_t key = rows->integer(0);
    if (key < firstKey || (last && key <= *last))
      return damaged(Sentence{"its rows are not in order after %1", last.value_or(firstKey)});
    last = key;
    const auto goesOn = each(*rows);
    if (!goesOn) return goesOn.error();
    if (!*goesOn) return {};
  }
  if (step == Statement::Step::failed) return damaged(database.lastError());
  return {};
}

Result<void> RecordedInsertion::Content::forEachBlock(
    std::uint64_t firstTick,
    const std::function<Result<bool>(std::span<const haptics::TickRecord>, const Statement&)>& each)
    const
{
  if (!hasBlocks())
    return forEachRising(
        selectTicks(), keyOf(firstTick), [&](const Statement& row) -> Result<bool> {
          const auto record =
              row.type(1) == Statement::Type::blob ? readTick(row.blob(1)) : std::nullopt;
          if (!record || record->tick != static_cast<std::uint64_t>(row.integer(0)))
            return damaged(Sentence{"the record of tick %1 cannot be read", row.integer(0)});
          return each(std::span(&*record, 1), row);
        });

  // the first tick may be within a block
  std::int64_t first = keyOf(firstTick);
  auto before =
      database.prepare("SELECT tick FROM block WHERE tick <= ? ORDER BY tick DESC LIMIT 1");
  if (!before) return damaged(before.error().message);
  before->bind(0, first);
  const Statement::Step found = before->step();
  if (found == Statement::Step::failed) return damaged(database.lastError());
  if (found == Statement::Step::row) first = std::min(first, before->integer(0));

  BlockUnpacker unpacker;
  std::optional<std::uint64_t> last;
  return forEachRising(
      "SELECT tick, ticks, packed FROM block WHERE tick >= ? ORDER BY tick", first,
      [&](const Statement& row) -> Result<bool> {
        const auto records =
            row.type(2) == Statement::Type::blob
                ? unpacker.unpack(row.blob(2), static_cast<std::uint64_t>(row.integer(1)))
                : std::span<const haptics::TickRecord>();
        if (records.empty() || records.front().tick != static_cast<std::uint64_t>(row.integer(0)) ||
            (last && records.front().tick <= *last))
          return damaged(Sentence{"the block of tick %1 cannot be read", row.integer(0)});
        last = records.back().tick;
        if (database.hasToStop()) return damaged(Sentence{});
        return each(records, row);
      });
}

Result<void> RecordedInsertion::Content::readMeta()
{
  std::size_t bytes = 0;
  return forEachRising(
      "SELECT rowid, key, value FROM meta WHERE rowid >= ? ORDER BY rowid",
      std::numeric_limits<std::int64_t>::min(), [&](const Statement& row) -> Result<bool> {
        if (row.type(1) != Statement::Type::text || row.type(2) != Statement::Type::text)
          return damaged(Sentence{"a fact about it is not text"});
        // Format 1 had other names for some facts.
        const std::string key = database.version() < firstVersionWithHash
                                    ? std::string(currentKey(row.text(1)))
                                    : row.text(1);
        const std::string value = row.text(2);
        bytes += key.size() + value.size();
        if (meta.size() >= maxMetaRows || bytes > maxMetaBytes)
          return damaged(Sentence{"it says more about itself than a recording does"});
        if (!meta.emplace(key, value).second)
          return damaged(Sentence{"a fact about it is there twice"});
        return true;
      });
}

Result<void> RecordedInsertion::Content::readFacts()
{
  if (const auto done = readMeta(); !done) return done.error();
  const auto read = factsIn(meta);
  if (!read) return damaged(Sentence{"facts about it are missing"});
  facts = *read;
  const bool hasHash = meta.count(MetaKey::contentHash) != 0;
  const bool isInFormat = database.version() >= firstVersionWithHash;
  if (hasHash && !isInFormat) return damaged(Sentence{"its format has no hash, and there is one"});
  if (!hasHash && (isInFormat || hasToBeSealed(facts.buildId, sealsRecordings) ||
                   hasToBeSealed(facts.version, sealsRecordings)))
    return damaged(Sentence{"its hash is missing"});
  const auto closed = flagIn(meta, MetaKey::closed);
  if (!closed) return damaged(Sentence{"it does not say whether it was closed"});
  wasClosed = *closed;
  if (wasClosed) highlights = highlightsIn(meta);
  lostRecords = countIn(meta, MetaKey::lostRecords).value_or(0);
  // A recording that was not closed does not contain the sum of its losses.
  std::uint64_t missing = 0;
  const auto done =
      forEachRising("SELECT rowid, kind, value FROM event WHERE rowid >= ? ORDER BY rowid", 1,
                    [&missing](const Statement& row) -> Result<bool> {
                      if (row.text(1) == "lost" && row.integer(2) > 0)
                        missing += static_cast<std::uint64_t>(row.integer(2));
                      return true;
                    });
  if (!done) return done.error();
  lostRecords = std::max(lostRecords, missing);
  return {};
}

RecordedInsertion::RecordedInsertion() = default;
RecordedInsertion::RecordedInsertion(RecordedInsertion&&) noexcept = default;
RecordedInsertion& RecordedInsertion::operator=(RecordedInsertion&&) noexcept = default;
RecordedInsertion::~RecordedInsertion() = default;

Result<RecordedInsertion> RecordedInsertion::open(const fs::path& file, std::stop_token stop)
{
  auto database = Database::open(file, recordingKind(), std::move(stop));
  if (!database) return database.error();
  RecordedInsertion opened;
  opened.content_ = std::make_unique<Content>(file, *std::move(database));
  Content& content = *opened.content_;
  if (const auto done = content.readFacts(); !done) return done.error();
  content.note = content.database.note();
  if (content.note.empty() && opened.isBeingWritten())
    content.note =
        file.string() +
        " is still being recorded: another program has it open, and has not closed it. "
        "Read is what it held when it was opened; read it again after the insertion for the rest.";
  return opened;
}

const RecordingFacts& RecordedInsertion::facts() const noexcept { return content_->facts; }

std::uint64_t RecordedInsertion::ticks() const
{
  // Counted row by row: SQLite's own count is one instruction, which cannot be interrupted.
  const char* rows = content_->hasBlocks()
                         ? "SELECT tick, ticks FROM block WHERE tick >= ? ORDER BY tick"
                         : "SELECT tick, 1 FROM tick WHERE tick >= ? ORDER BY tick";
  std::uint64_t count = 0;
  static_cast<void>(
      content_->forEachRising(rows, 0, [&count, this](const Statement& row) -> Result<bool> {
        const auto ticks = static_cast<std::uint64_t>(row.integer(1));
        if (content_->lastTick && static_cast<std::uint64_t>(row.integer(0)) > *content_->lastTick)
          return false;
        if (ticks <= blockTicks) count += ticks;  // others cannot be read
        return ticks <= blockTicks;
      }));
  return count;
}

std::uint64_t RecordedInsertion::lostRecords() const { return content_->lostRecords; }

bool RecordedInsertion::wasClosed() const noexcept { return content_->wasClosed; }

bool RecordedInsertion::isBeingWritten() const noexcept
{
  return !content_->wasClosed && content_->database.isShared();
}

const std::string& RecordedInsertion::note() const noexcept { return content_->note; }

void RecordedInsertion::endAfter(std::uint64_t lastTick) noexcept
{
  content_->lastTick = lastTick;
  content_->highlights.reset();  // they are those of all ticks
}

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

Result<void> RecordedInsertion::forEach(const std::function<bool(const haptics::TickRecord&)>& each,
                                        std::uint64_t firstTick) const
{
  const auto last = content_->lastTick;
  return content_->forEachBlock(
      firstTick,
      [&](std::span<const haptics::TickRecord> records, const Statement&) -> Result<bool> {
        const bool goesOn = std::all_of(records.begin(), records.end(), [&](const auto& record) {
          return record.tick < firstTick || ((!last || record.tick <= *last) && each(record));
        });
        return goesOn && (!last || records.back().tick < *last);
      });
}

}  // namespace perilymph::session
