// SPDX-License-Identifier: BSD-3-Clause
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <stop_token>

#include "Commands.h"
#include "Interruption.h"
#include "OutputFolder.h"
#include "StudyOptions.h"
#include "Terminal.h"
#include "perilymph/analysis/RunProgress.h"
#include "perilymph/foundation/InParallel.h"
#include "perilymph/study/StudyEstimate.h"
#include "perilymph/study/StudyFile.h"
#include "perilymph/study/StudyReport.h"
#include "perilymph/study/StudyRun.h"
#include "perilymph/study/StudySummary.h"

namespace perilymph::cli {

namespace {

using Clock = std::chrono::steady_clock;

double secondsSince(Clock::time_point begin)
{
  return std::chrono::duration<double>(Clock::now() - begin).count();
}

/// "40 s", "12 min", "3.5 h".
std::string durationText(double seconds)
{
  if (seconds < 100.0) return fixed(seconds, 0) + " s";
  if (seconds < 6000.0) return fixed(seconds / 60.0, 0) + " min";
  return fixed(seconds / 3600.0, 1) + " h";
}

/// "300 kB", "12 MB", "3.5 GB".
std::string sizeText(double bytes)
{
  if (bytes < 1e6) return fixed(bytes / 1e3, 0) + " kB";
  if (bytes < 1e9) return fixed(bytes / 1e6, 0) + " MB";
  return fixed(bytes / 1e9, 1) + " GB";
}

/// Shows done insertions, rate and time left if standard error is a terminal, and looks for a
/// request to end.
analysis::RunProgress progressShown()
{
  const auto begin = Clock::now();
  auto before = std::make_shared<std::optional<std::size_t>>();
  return [begin, before](std::size_t done, std::size_t all) {
    if (!*before) *before = done;  // from an earlier run
    const double seconds = secondsSince(begin);
    const double rate = static_cast<double>(done - **before) / std::max(seconds, 1e-3);
    if (::isatty(STDERR_FILENO) != 0) {
      printError("\r\x1b[Kinsertion {} of {}, {} per second", done, all, fixed(rate, 1));
      if (rate > 0.0 && done < all)
        printError(", {} left", durationText(static_cast<double>(all - done) / rate));
      if (done == all) printError("\r\x1b[K");
      std::fflush(stderr);
    }
    static_cast<void>(isInterrupted());
  };
}

Result<study::Shard> shardIn(const study::Study& study, const StudyOptions& options)
{
  if (options.index > options.shards)
    return Error{"--index " + std::to_string(options.index) + " is above --of " +
                 std::to_string(options.shards) + ". Parts count from 1."};
  return study::shardOf(study.size(), options.index, options.shards);
}

/// Says on standard error what there is to say of a study's patients.
void printNotesOn(const std::vector<std::string>& patients)
{
  for (const std::string& note : patients) printError("{}\n", note);
}

/// Merges the parts in a folder. @return what is said of their patients.
Result<std::vector<std::string>> mergeParts(const StudyOptions& options)
{
  const auto merged = study::mergeShards(options.folder);
  if (!merged) return merged.error();
  const std::filesystem::path folder(options.folder);
  print("{} insertions\n{}\n{}\n", merged->cases, (folder / study::mergedFile).string(),
        (folder / study::mergedTable).string());
  return merged->notes;
}

/// Runs a shard with progress. An interruption is an error that says what was kept.
Result<void> runPart(const study::Study& study, const study::Shard& shard,
                     const StudyOptions& options)
{
  if (const auto checked = checkStudyFolder(options.folder); !checked) return checked;
  const std::stop_token stop = watchForInterruption();
  const auto done =
      study::runShard(study, shard, options.folder, options.jobs, progressShown(), stop);
  if (!done) return done.error();
  if (*done) return {};
  return Error{"Interrupted; what was done is kept. The same command continues."};
}

}  // namespace

Result<study::Study> readStudy(const StudyOptions& options)
{
  auto study = study::loadStudy(options.file);
  if (study) printNotesOn(study->notes());
  return study;
}

Result<void> checkStudyFolder(const std::string& folder)
{
  const auto states = study::shardsIn(folder);  // none where there is no folder yet
  return checkReplaced(folder, {study::mergedFile, study::mergedTable}, states && !states->empty());
}

Result<void> checkStudy(const StudyOptions& options)
{
  const auto study = readStudy(options);
  if (!study) return study.error();
  print("{}: {} insertions, {} cochleae with {} each\n", study->title(), study->size(),
        study->cochleae().size(), study->casesPerCochlea());

  const auto cost = study::estimate(*study);
  if (!cost) return cost.error();
  const unsigned cores = processors();
  print("about {} on {} cores of this machine, {} on disk\n",
        durationText(cost->processorTime_s / cores), cores, sizeText(cost->bytes));
  return {};
}

Result<void> runWholeStudy(const StudyOptions& options)
{
  const auto study = readStudy(options);
  if (!study) return study.error();
  const auto done = runPart(*study, study::shardOf(study->size(), 1, 1), options);
  if (!done) return done;
  const auto merged = mergeParts(options);
  return merged ? Result<void>() : merged.error();
}

Result<void> runStudyShard(const StudyOptions& options)
{
  const auto study = readStudy(options);
  if (!study) return study.error();
  const auto shard = shardIn(*study, options);
  if (!shard) return shard.error();
  const auto done = runPart(*study, *shard, options);
  if (!done) return done;
  print("{}: insertions {} to {}\n",
        (std::filesystem::path(options.folder) / fileNameOf(*shard)).string(), shard->first,
        shard->end == shard->first ? shard->first : shard->end - 1);
  return {};
}

Result<void> mergeStudy(const StudyOptions& options)
{
  const auto notes = mergeParts(options);
  if (!notes) return notes.error();
  printNotesOn(*notes);
  return {};
}

namespace {

/// Tables of the groups of a setting, with the angle over the size of the cochlea as their trend.
Result<std::vector<std::pair<std::string, std::string>>> groupTables(
    const study::StudyColumns& columns, const std::string& group)
{
  std::string known;
  for (const study::StudyFactor& factor : columns.factors()) {
    known += (known.empty() ? "" : ", ") + factor.key;
    if (factor.key != group) continue;
    const auto rows = columns.rows({});
    const auto summary = study::summaryOf(columns, rows, {"A_mm", "angle_deg", group});
    std::vector<std::pair<std::string, std::string>> tables;
    for (auto& [name, text] : study::tablesOf(columns, rows, summary))
      tables.emplace_back(name, std::move(text));
    return tables;
  }
  return Error{"--group %1 is no setting of this study with 2 to 12 values. Give one of: %2.",
               group, known.empty() ? std::string("none") : known};
}

}  // namespace

Result<void> reportStudy(const StudyOptions& options, const CommandFiles& files)
{
  const auto columns = study::StudyColumns::read(
      std::filesystem::path(options.folder) / study::mergedFile, {}, study::maxCases);
  if (!columns) return columns.error();
  const study::StudyReport report = study::reportOf(*columns);
  if (const std::string note = noteOn(columns->facts().seal); !note.empty()) print("{}\n", note);
  printNotesOn(columns->facts().notes);
  FolderContent content;
  content.texts = {{"report.md", report.text}};
  if (!options.group.empty()) {
    auto tables = groupTables(*columns, options.group);
    if (!tables) return tables.error();
    for (auto& table : *tables) content.texts.push_back(std::move(table));
  }
  for (const auto& [name, figure] : report.figures)
    content.figures.emplace_back(name, figures::draw(figure));
  return writeFolder(files, options.folder, content);
}

Result<void> showStudyStatus(const StudyOptions& options)
{
  const auto states = study::shardsIn(options.folder);
  if (!states) return states.error();
  // Of the study that the first part is of: parts of two divisions may have insertions in common.
  const study::ShardState* first = nullptr;
  std::size_t done = 0, counted = 0, parts = 0;
  for (const study::ShardState& state : *states) {
    if (!state.error.empty()) {
      print("{}\n", state.error);
      continue;
    }
    if (first == nullptr) {
      first = &state;
      printNotesOn(state.notes);
    }
    if (state.fingerprint != first->fingerprint || state.cases != first->cases) {
      print("{} is of another study than {}\n", state.file.filename().string(),
            first->file.filename().string());
      continue;
    }
    const std::size_t end = state.shard.first + state.done;
    done += end - std::min(end, std::max(counted, state.shard.first));
    counted = std::max(counted, end);
    ++parts;
    print("{}: {} of {}\n", state.file.filename().string(), state.done,
          state.shard.end - state.shard.first);
  }
  print("{} {}, {} of {} insertions of the study\n", parts, parts == 1 ? "part" : "parts", done,
        first == nullptr ? 0 : first->cases);
  return {};
}

}  // namespace perilymph::cli
