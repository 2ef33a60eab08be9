#include "perilymph/session/SessionLibrary.h"

#include <algorithm>
#include <chrono>
#include <set>
#include <system_error>

#include "SessionIndex.h"
#include "perilymph/foundation/TomlReader.h"
#include "perilymph/session/RecordedInsertion.h"
#include "perilymph/session/Scenario.h"

namespace perilymph::session {

namespace {

namespace fs = std::filesystem;

/// What identifies a version of a file.
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

/// Who and what: from the scenario's text alone, so that a recording whose array has left the
/// catalog can still be listed.
void describeScenario(SessionSummary& summary, const std::string& text)
{
  auto keys = TomlReader::parse(text, summary.file.string());
  if (!keys) {
    summary.trouble = keys.error().message;
    return;
  }
  summary.side = keys->text("side", "right");
  summary.array = keys->text("array", "contour");
  const std::string anatomy = keys->text("anatomy", "published");
  auto patient = keys->table("patient_numbers");
  // an anatomy that is nobody's has no patient
  const bool isPatient = anatomy == "published" || patient.has("a_mm");
  summary.patient = isPatient ? patient.text("label", anatomy) : anatomy + " anatomy";
  const auto scenario = parseScenario(text, summary.file.string());
  if (scenario)
    summary.array = scenario->array.name;
  else
    summary.trouble = "It can be compared, but not replayed: " + scenario.error().message;
}

/// A recording with a log may grow without its file being touched.
bool hasLog(const fs::path& file)
{
  std::error_code ignored;
  return fs::exists(file.string() + "-wal", ignored);
}

/// Trouble may be mended by what the file does not show: its permissions, the catalog of arrays.
bool isWorthKeeping(const SessionSummary& summary)
{
  return summary.trouble.empty() || (!summary.startedUtc.empty() && !summary.wasClosed);
}

}  // namespace

fs::path libraryCache(const fs::path& folder) { return folder / ".cache"; }

SessionSummary summarize(const fs::path& file)
{
  SessionSummary summary;
  summary.file = file;
  const auto recorded = RecordedInsertion::open(file);
  if (!recorded) {
    summary.trouble = recorded.error().message;
    stamp(summary);
    return summary;
  }
  const RecordingFacts& facts = recorded->facts();
  summary.startedUtc = facts.startedUtc;
  summary.scenario = facts.scenarioName;
  summary.device = facts.device;
  summary.version = facts.version;
  summary.wasClosed = recorded->wasClosed();
  describeScenario(summary, facts.scenarioText);
  const auto highlights = recorded->highlights();
  if (highlights)
    summary.highlights = *highlights;
  else
    summary.trouble = highlights.error().message;
  if (summary.trouble.empty() && !summary.wasClosed)
    summary.trouble = "It was not closed: it ends where the program did.";
  if (summary.trouble.empty() && highlights && highlights->ticks == 0)
    summary.trouble = "It holds no tick: the insertion never ran.";
  // Last: opening one that was not closed may have folded its log into it.
  stamp(summary);
  return summary;
}

Result<std::vector<SessionSummary>> listSessions(const fs::path& folder,
                                                 const fs::path& beingRecorded,
                                                 const LibraryProgress& progress)
{
  std::vector<SessionSummary> sessions;
  std::error_code failure;
  if (!fs::exists(folder, failure)) return sessions;  // nothing was ever recorded
  fs::directory_iterator entries(folder, failure);
  if (failure)
    return Error{"The folder of sessions " + folder.string() +
                 " cannot be read: " + failure.message() + ". Check its permissions."};
  std::vector<fs::path> files;
  for (const fs::directory_entry& entry : entries)
    if (entry.path().extension() == ".insertion") files.push_back(entry.path());

  SessionIndex index(folder);
  std::set<std::string> names;
  for (const fs::path& file : files) {
    if (progress && !progress(sessions.size(), files.size())) {
      index.close();
      return Error{"Stopped after " + std::to_string(sessions.size()) + " of " +
                   std::to_string(files.size()) + " recordings."};
    }
    SessionSummary summary;
    summary.file = file;
    stamp(summary);
    names.insert(file.filename().string());
    if (file == beingRecorded) {
      summary.isBeingRecorded = true;
    } else if (auto known = hasLog(file) ? std::nullopt
                                         : index.find(file.filename().string(), summary.bytes,
                                                      summary.modified_ns)) {
      summary = *std::move(known);
      summary.file = file;
    } else {
      summary = summarize(file);
      if (isWorthKeeping(summary)) index.keep(summary);
    }
    sessions.push_back(std::move(summary));
  }
  index.forget(names);
  index.close();
  std::stable_sort(sessions.begin(), sessions.end(),
                   [](const SessionSummary& one, const SessionSummary& other) {
                     if (one.isBeingRecorded != other.isBeingRecorded) return one.isBeingRecorded;
                     return one.startedUtc > other.startedUtc;
                   });
  return sessions;
}

}  // namespace perilymph::session
