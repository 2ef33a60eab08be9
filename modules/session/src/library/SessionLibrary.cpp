// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/session/SessionLibrary.h"

#include <algorithm>
#include <chrono>
#include <map>
#include <set>
#include <stop_token>
#include <system_error>

#include "library/SessionIndex.h"
#include "perilymph/foundation/CallNoThrow.h"
#include "perilymph/foundation/TomlReader.h"
#include "perilymph/session/RecordedInsertion.h"
#include "perilymph/session/Scenario.h"

namespace perilymph::session {

namespace {

namespace fs = std::filesystem;

/// Fills what identifies a version of a file.
void stamp(SessionSummary& summary)
{
  std::error_code ignored;
  summary.bytes = fs::file_size(summary.file, ignored);
  if (ignored) summary.bytes = 0;
  const auto time = fs::last_write_time(summary.file, ignored);
  if (!ignored)
    summary.modified_ns =
        std::chrono::duration_cast<std::chrono::nanoseconds>(time.time_since_epoch()).count();
}

/// Subjects by scenario text: many recordings share a scenario.
using Subjects = std::map<std::string, ScenarioSubject>;

void describeScenario(SessionSummary& summary, const std::string& text, Subjects& known)
{
  const auto found = known.find(text);
  const ScenarioSubject subject =
      found != known.end() ? found->second : subjectOf(text, summary.file.string());
  summary.patient = subject.patient;
  summary.side = subject.side;
  summary.array = subject.array;
  summary.technique = subject.technique;
  summary.error = subject.error;
  // an error message names its file
  if (found == known.end() && subject.error.empty()) known.emplace(text, subject);
}

/// A recording with a log may grow without a change of the file itself.
bool hasLog(const fs::path& file)
{
  std::error_code ignored;
  return fs::exists(file.string() + "-wal", ignored);
}

/// Errors may depend on more than the file: on permissions, on the catalog of arrays.
bool isWorthKeeping(const SessionSummary& summary)
{
  return summary.error.empty() || (!summary.startedUtc.empty() && !summary.wasClosed);
}

}  // namespace

bool isInsertion(const SessionSummary& summary) noexcept
{
  return !summary.isBeingRecorded && summary.highlights.duration > 0.0;
}

ScenarioSubject subjectOf(const std::string& text, const std::string& name)
{
  ScenarioSubject subject;
  auto keys = TomlReader::parse(text, name);
  if (!keys) {
    subject.error = keys.error().message;
    return subject;
  }
  subject.side = keys->text("side", "right");
  if (!valueIn(anatomy::sides, subject.side)) subject.side.clear();  // parseScenario() says so
  subject.array = keys->text("array", "contour");
  subject.technique = keys->text("technique", nameOf(Technique::standard));
  const std::string anatomy = keys->text("anatomy", nameOf(anatomy::AnatomySource::published));
  const auto source = anatomy::anatomySourceNamed(anatomy);
  auto patient = keys->table("patient_numbers");
  // an anatomy without patient numbers has no patient
  const bool isPatient = (source && traitsOf(*source).alwaysTakes) || patient.has("a_mm");
  subject.patient = isPatient ? patient.text("label", anatomy) : anatomy + " anatomy";
  subject.cochlea = anatomy;
  const auto scenario = parseScenario(text, name);
  if (!scenario) {
    subject.error =
        Sentence{"Can be compared but not replayed: %1", Sentence(scenario.error().message)};
    return subject;
  }
  subject.array = scenario->array().name;
  if (!isPatient) return subject;
  for (const auto& [key, value] : scenario->values())
    if (key.starts_with("patient_numbers.") && key != "patient_numbers.label" &&
        !key.ends_with("_sd_mm"))
      subject.cochlea += " " + key + "=" + value;
  return subject;
}

fs::path libraryCache(const fs::path& folder) { return folder / ".cache"; }

std::optional<fs::path> makeLibraryCache(const fs::path& folder)
{
  const fs::path cache = libraryCache(folder);
  std::error_code failure;
  fs::create_directory(cache, failure);
  if (!fs::is_directory(fs::symlink_status(cache, failure))) return std::nullopt;
  return cache;
}

namespace {

SessionSummary summarize(const fs::path& file, Subjects& known, const std::stop_token& stop)
{
  SessionSummary summary;
  summary.file = file;
  const auto recorded = RecordedInsertion::open(file, stop);
  if (!recorded) {
    summary.error = recorded.error().message;
    stamp(summary);
    return summary;
  }
  const RecordingFacts& facts = recorded->facts();
  summary.startedUtc = facts.startedUtc;
  summary.scenario = facts.scenarioName;
  summary.device = facts.device;
  summary.version = facts.version;
  summary.wasClosed = recorded->wasClosed();
  describeScenario(summary, facts.scenarioText, known);
  const auto highlights = recorded->highlights();
  if (highlights)
    summary.highlights = *highlights;
  else
    summary.error = highlights.error().message;
  if (summary.error.empty() && !isInsertion(summary))
    summary.error = Sentence{"Empty: the program ended before the insertion began; delete it."};
  else if (summary.error.empty() && !summary.wasClosed)
    summary.error = Sentence{"Incomplete: the program was interrupted."};
  // Last, because opening an unclosed recording may have changed the file.
  stamp(summary);
  return summary;
}

/// Summarizes a file; an exception (it requests too much memory) does not hide other files.
SessionSummary summarizeNoThrow(const fs::path& file, Subjects& known, const std::stop_token& stop)
{
  const auto summary = callNoThrow("The recording " + file.string(), [&] {
    return Result<SessionSummary>(summarize(file, known, stop));
  });
  if (summary) return *summary;
  SessionSummary unreadable;
  unreadable.file = file;
  unreadable.error = summary.error().message;
  stamp(unreadable);
  return unreadable;
}

}  // namespace

SessionSummary summarize(const fs::path& file, const std::stop_token& stop)
{
  Subjects none;
  return summarizeNoThrow(file, none, stop);
}

Result<std::vector<SessionSummary>> listSessions(const fs::path& folder,
                                                 const fs::path& beingRecorded,
                                                 const LibraryProgress& progress,
                                                 const LibraryEntry& listed,
                                                 const std::stop_token& stop)
{
  std::vector<SessionSummary> sessions;
  std::error_code failure;
  if (!fs::exists(folder, failure)) return sessions;  // nothing was recorded yet
  fs::directory_iterator entries(folder, failure);
  if (failure)
    return Error{"The folder of recordings %1 cannot be read: %2. Check its permissions.", folder,
                 failure.message()};
  std::vector<fs::path> files;
  for (const fs::directory_entry& entry : entries)
    if (entry.path().extension() == ".insertion") files.push_back(entry.path());
  std::sort(files.begin(), files.end(), std::greater<>());

  SessionIndex index(folder);
  Subjects subjects;
  std::set<std::string> names;
  for (const fs::path& file : files) names.insert(file.filename().string());
  for (const fs::path& file : files) {
    if (progress) progress(sessions.size(), files.size());
    if (stop.stop_requested()) break;
    SessionSummary summary;
    summary.file = file;
    stamp(summary);
    if (file == beingRecorded) {
      summary.isBeingRecorded = true;
    } else if (auto known = hasLog(file) ? std::nullopt
                                         : index.find(file.filename().string(), summary.bytes,
                                                      summary.modified_ns)) {
      summary = *std::move(known);
      summary.file = file;
    } else {
      summary = summarizeNoThrow(file, subjects, stop);
      if (stop.stop_requested()) break;
      if (isWorthKeeping(summary)) index.keep(summary);
    }
    if (listed) listed(summary);
    sessions.push_back(std::move(summary));
  }
  index.removeAbsent(names);
  index.close();
  std::stable_sort(sessions.begin(), sessions.end(),
                   [](const SessionSummary& one, const SessionSummary& other) {
                     if (one.isBeingRecorded != other.isBeingRecorded) return one.isBeingRecorded;
                     return one.startedUtc > other.startedUtc;
                   });
  return sessions;
}

}  // namespace perilymph::session
