// SPDX-License-Identifier: BSD-3-Clause
#include "gui/pages/studies/StudyRunWork.h"

#include <stop_token>
#include <utility>

#include "gui/text/DataText.h"
#include "perilymph/study/StudyRun.h"

namespace perilymph::gui {

namespace {

namespace fs = std::filesystem;

constexpr int reportInterval_ms = 250;
constexpr double shortestForRate_s = 1.0;  // earlier, a rate says nothing (choice, high)

}  // namespace

StudyRunWork::StudyRunWork(QObject* parent) : QObject(parent), background_(this)
{
  timer_.setInterval(reportInterval_ms);
  connect(&timer_, &QTimer::timeout, this, &StudyRunWork::report);
}

template <class Folder>
void StudyRunWork::run(Folder folder, unsigned jobs)
{
  shared_ = std::make_shared<Shared>();
  isCounting_ = false;
  background_.run(
      "The study",
      [folder = std::move(folder), jobs,
       shared = shared_](const std::stop_token& stop) -> Result<StoredStudy> {
        const Result<fs::path> place = folder();
        if (!place) return place.error();
        const auto study = study::loadStudy(*place / studySettingsFile);
        if (!study) return study.error();
        const auto ran = study::runShard(
            *study, study::shardOf(study->size(), 1, 1), *place, jobs,
            [&shared](std::size_t done, std::size_t all) {
              shared->done = done;
              shared->all = all;
            },
            stop);
        if (!ran) return ran.error();
        if (*ran)
          if (const auto merged = study::mergeShards(*place); !merged) return merged.error();
        return readStoredStudy(*place);
      },
      [this](const Result<StoredStudy>& study) {
        timer_.stop();
        if (!study) return failed(dataText(study.error().message));
        Q_EMIT ended(*study);
      });
  timer_.start();
}

void StudyRunWork::start(const StudyDraft& draft, unsigned jobs)
{
  run([draft] { return saveStudy(draft); }, jobs);
}

void StudyRunWork::resume(const fs::path& folder, unsigned jobs)
{
  run([folder]() -> Result<fs::path> { return folder; }, jobs);
}

void StudyRunWork::report()
{
  const std::size_t done = shared_->done, all = shared_->all;
  if (all == 0) return;
  if (!std::exchange(isCounting_, true)) {
    begin_ = Clock::now();
    first_ = done;
  }
  const double seconds = std::chrono::duration<double>(Clock::now() - begin_).count();
  const bool isKnown = done > first_ && seconds > shortestForRate_s;
  Q_EMIT progressed(done, all,
                    isKnown ? seconds * double(all - done) / double(done - first_) : -1.0);
}

void StudyEstimateWork::check(const StudyDraft& draft)
{
  using Found = std::pair<study::StudyEstimate, std::size_t>;
  background_.run(
      "The study",
      [draft](const std::stop_token& stop) -> Result<Found> {
        const auto study = study::parseStudy(studyText(draft), studySettingsFile);
        if (!study) return study.error();
        const auto cost = study::estimate(*study, stop);
        if (!cost) return cost.error();
        return Found{*cost, study->size()};
      },
      [this](const Result<Found>& found) {
        if (!found) return refused(dataText(found.error().message));
        Q_EMIT estimated(found->first, found->second);
      });
}

}  // namespace perilymph::gui
