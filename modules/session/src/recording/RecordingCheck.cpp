// SPDX-License-Identifier: BSD-3-Clause

// Consistency check of a recording: counts, gaps, columns, events, hash.

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "perilymph/session/Csv.h"
#include "recording/RecordedContent.h"
#include "recording/RecordingEvents.h"
#include "recording/TickBlock.h"

namespace perilymph::session {

namespace {

using database::Statement;
using Type = Statement::Type;

/// SQLite stores NaN as NULL, and may return -0.0 as 0.0.
bool holds(const Statement& row, int column, double expected)
{
  if (std::isnan(expected)) return row.type(column) == Type::null;
  return row.type(column) == Type::real && row.real(column) == expected;
}

/// A list of status names as in format 1.
std::string inFirstWords(std::string statuses)
{
  const std::pair<std::string, std::string> words[] = {{"notConverged", "notSettled"},
                                                       {"sampleRejected", "sampleDoubted"}};
  for (const auto& [now, before] : words)
    if (const auto place = statuses.find(now); place != std::string::npos)
      statuses.replace(place, now.size(), before);
  return statuses;
}

struct HoldsValue {
  const Statement& row;
  int column;

  bool operator()(double expected) const { return holds(row, column, expected); }
  bool operator()(std::int64_t expected) const
  {
    return row.type(column) == Type::integer && row.integer(column) == expected;
  }
  bool operator()(const std::string& expected) const
  {
    return row.type(column) == Type::text && row.text(column) == expected;
  }
};

bool holds(const Statement& row, const Event& event)
{
  return HoldsValue{row, 1}(static_cast<std::int64_t>(event.tick)) && holds(row, 2, event.time) &&
         HoldsValue{row, 3}(event.kind) && std::visit(HoldsValue{row, 4}, event.value);
}

/// Data collected from the ticks of a recording.
struct TickSurvey {
  std::uint64_t ticks = 0;
  Sha256 rows;
  std::vector<Event> events;
  std::uint64_t missingTicks = 0;
  std::string damage;  ///< First inconsistency of the columns, in formats that have them.
};

/// The first column of a row of the table `tick` that is not that of its record; empty if all are.
std::string differingColumn(const haptics::TickRecord& record, const Statement& row)
{
  const auto values = columnValues(record);
  for (std::size_t i = 0; i < recordedColumnCount; ++i)
    if (!holds(row, 2 + static_cast<int>(i), values[i]))
      return std::string(recordedNames[i]) + " of tick " + std::to_string(record.tick) +
             " is not that of its record";
  return {};
}

}  // namespace

std::string noteOn(const RecordingCheck& check, const std::filesystem::path& file)
{
  if (!check.damage.empty())
    return file.string() + " was changed after it was recorded: " + check.damage +
           ". Do not use its values as results of the program.";
  return check.hasHash ? std::string()
                       : file.string() + " carries no seal: it is of an earlier version.";
}

Result<RecordingCheck> RecordedInsertion::check() const
{
  const Content& content = *content_;
  TickSurvey survey;
  EventDetector detector;
  const auto addRow = [&](std::span<const haptics::TickRecord> records,
                          const Statement& row) -> Result<bool> {
    survey.ticks += records.size();
    for (const haptics::TickRecord& record : records) {
      const std::vector<Event> found = detector.add(record);
      survey.events.insert(survey.events.end(), found.begin(), found.end());
    }
    if (content.hasBlocks()) {
      addBlock(survey.rows, row.integer(0), row.integer(1), row.blob(2));
    } else {
      survey.rows.add(row.blob(1));
      if (survey.damage.empty()) survey.damage = differingColumn(records.front(), row);
    }
    return true;
  };
  if (const auto done = content.forEachBlock(0, addRow); !done) return done.error();

  std::size_t next = 0;
  bool eventsHold = true;
  const auto done = content.forEachRising(
      "SELECT rowid, tick, time_s, kind, value FROM event WHERE rowid >= ? ORDER BY rowid", 1,
      [&](const Statement& row) -> Result<bool> {
        if (next < survey.events.size() && content.database.version() < firstVersionWithHash)
          if (auto* words = std::get_if<std::string>(&survey.events[next].value))
            *words = inFirstWords(*words);
        eventsHold = eventsHold && next < survey.events.size() && holds(row, survey.events[next]);
        ++next;
        return eventsHold;
      });
  if (!done) return done.error();

  if (const auto pages = content.database.checkPages(); !pages) return pages.error();

  RecordingCheck result;
  result.ticks = survey.ticks;
  result.missingTicks = detector.missingTicks();
  result.hasHash = content.meta.count(MetaKey::contentHash) != 0;
  const auto noted = countIn(content.meta, MetaKey::ticks);
  if (content.wasClosed && noted && *noted != survey.ticks)
    result.damage = "it holds " + std::to_string(survey.ticks) + " of the " +
                    std::to_string(*noted) + " ticks it was closed with";
  else if (!survey.damage.empty())
    result.damage = survey.damage;
  else if (!eventsHold || next != survey.events.size())
    result.damage = "its events are not those of its ticks";
  else if (sealIn(content.meta, survey.rows, result.hasHash) == Seal::changed)
    result.damage = "its hash is that of other ticks or other facts";
  return result;
}

}  // namespace perilymph::session
