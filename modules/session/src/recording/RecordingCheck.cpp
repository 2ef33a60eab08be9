// SPDX-License-Identifier: BSD-3-Clause

// Consistency check of a recording: counts, gaps, columns, events, hash.

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "perilymph/session/Csv.h"
#include "recording/RecordedContent.h"
#include "recording/RecordingEvents.h"
#include "recording/TickBlob.h"

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
  Sha256 records;
  std::vector<Event> events;
  std::uint64_t missingTicks = 0;
  std::string damage;  ///< First inconsistency of the columns.
};

std::string selectTicks()
{
  std::string columns = "tick, record";
  for (const char* name : recordedNames) columns += std::string(", ") + name;
  return "SELECT " + columns + " FROM tick WHERE tick >= ? ORDER BY tick";
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
  const auto addTick = [&](const Statement& row) -> Result<bool> {
    const bool isBlob = row.type(1) == Type::blob;
    const auto record = readTick(row.blob(1));
    if (!isBlob || !record || record->tick != static_cast<std::uint64_t>(row.integer(0)))
      return content.damaged(Sentence{"the record of tick %1 cannot be read", row.integer(0)});
    ++survey.ticks;
    survey.records.add(row.blob(1));
    const std::vector<Event> found = detector.add(*record);
    survey.events.insert(survey.events.end(), found.begin(), found.end());
    const auto values = columnValues(*record);
    for (int i = 0; i < recordedColumnCount && survey.damage.empty(); ++i)
      if (!holds(row, 2 + i, values[static_cast<std::size_t>(i)]))
        survey.damage = std::string(recordedNames[static_cast<std::size_t>(i)]) + " of tick " +
                        std::to_string(record->tick) + " is not that of its record";
    return true;
  };
  if (const auto done = content.forEachRising(selectTicks(), 0, addTick); !done)
    return done.error();

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
  else if (sealIn(content.meta, survey.records, result.hasHash) == Seal::changed)
    result.damage = "its hash is that of other ticks or other facts";
  return result;
}

}  // namespace perilymph::session
