// SPDX-License-Identifier: BSD-3-Clause
#include "gui/pages/studies/StudyWork.h"

#include <cmath>
#include <stop_token>
#include <utility>

#include "gui/text/DataText.h"
#include "gui/text/Numbers.h"
#include "perilymph/foundation/Resources.h"
#include "perilymph/foundation/Unfinished.h"
#include "perilymph/study/StudyCaseRun.h"

namespace perilymph::gui {

namespace {

namespace fs = std::filesystem;

/// A recording, and the peak force of its insertion if it was run now.
struct CaseRecording {
  fs::path file;
  std::optional<double> peak_mN;
};

/// Named by the study's fingerprint, so that no two studies share one.
fs::path recordingOf(const study::StudyFileFacts& facts, std::size_t number)
{
  return sessionFolder() / ("study-" + facts.fingerprint.substr(0, 8) + "-insertion-" +
                            std::to_string(number) + ".insertion");
}

Result<CaseRecording> recordingOf(const study::StudyFileFacts& facts, const fs::path& file,
                                  std::size_t number, const std::stop_token& stop)
{
  const fs::path recording = recordingOf(facts, number);
  std::error_code problem;
  if (fs::exists(recording, problem)) return CaseRecording{recording, std::nullopt};
  fs::create_directories(recording.parent_path(), problem);
  const auto study = study::studyIn(facts, file);
  if (!study) return study.error();
  // under another name until it is whole
  const fs::path unfinished = unfinishedPath(fs::path(recording).replace_extension());
  const auto result = study::recordCase(*study, number, unfinished, stop);
  if (result) fs::rename(unfinished, recording, problem);
  std::error_code ignored;
  for (const char* ending : {"", "-wal", "-shm", "-journal"})
    fs::remove(unfinished.string() + ending, ignored);
  if (!result) return result.error();
  if (problem)
    return Error{
        "%1 cannot be written: %2. Check the folder's permissions and the space on the disk.",
        recording, problem.message()};
  return CaseRecording{recording, inMillinewtons(result->insertion.peak.force)};
}

}  // namespace

void StudyWork::open(const fs::path& file)
{
  background_.run(
      "The study",
      [file](const std::stop_token& stop) -> Result<Columns> {
        auto columns = study::StudyColumns::read(file, stop);
        if (!columns) return columns.error();
        return std::make_shared<const study::StudyColumns>(*std::move(columns));
      },
      [this, file](const Result<Columns>& columns) {
        if (!columns) return failed(dataText(columns.error().message));
        Q_EMIT opened(*columns, file);
      });
}

void StudyWork::runAgain(const Columns& columns, const fs::path& file, std::size_t row)
{
  const study::StudyResult& result = columns->result(row);
  background_.run(
      "The insertion",
      [facts = columns->facts(), file, number = result.number](const std::stop_token& stop) {
        return recordingOf(facts, file, number, stop);
      },
      [this, number = result.number,
       before_mN = inMillinewtons(result.insertion.peak.force)](const Result<CaseRecording>& now) {
        if (!now) return failed(dataText(now.error().message));
        QString sentence;
        if (now->peak_mN) {
          // as shown
          const bool isSame = numberText(*now->peak_mN, 1) == numberText(before_mN, 1);
          sentence = isSame ? tr("Insertion %1 was run again: peak force %2 mN, as in the study.")
                                  .arg(number)
                                  .arg(numberText(*now->peak_mN, 1))
                            : tr("Insertion %1 was run again: peak force %2 mN; the study, run by "
                                 "another version, has %3 mN.")
                                  .arg(number)
                                  .arg(numberText(*now->peak_mN, 1), numberText(before_mN, 1));
        }
        Q_EMIT recorded(now->file, sentence);
      });
}

}  // namespace perilymph::gui
