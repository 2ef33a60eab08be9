// SPDX-License-Identifier: BSD-3-Clause
#include "gui/pages/ct/CtWork.h"

#include <algorithm>
#include <stop_token>
#include <utility>

#include "gui/text/DataText.h"

namespace perilymph::gui {

namespace {

constexpr int report_ms = 100;

}  // namespace

CtWork::CtWork(QObject* parent) : QObject(parent), background_(this)
{
  timer_.setInterval(report_ms);
  connect(&timer_, &QTimer::timeout, this, [this] {
    if (progress_) Q_EMIT progressed(progress_->load());
  });
}

CtWork::Progress CtWork::begin()
{
  isCanceled_ = false;
  progress_ = std::make_shared<std::atomic<double>>(0.0);
  timer_.start();
  return progress_;
}

void CtWork::end()
{
  timer_.stop();
  progress_.reset();
}

void CtWork::fail(const Sentence& sentence)
{
  Q_EMIT failed(isCanceled_ ? QString() : dataText(sentence));
}

void CtWork::open(const std::filesystem::path& path, const std::string& series)
{
  const Progress progress = begin();
  background_.run(
      "The CT",
      [path, progress](const std::stop_token& stop) {
        return imaging::findSeries(path,
                                   {[progress](double done) { progress->store(done); }, stop});
      },
      [this, series](const Result<imaging::CtSeriesList>& list) {
        end();
        if (!list) return fail(list.error().message);
        Q_EMIT listed(*list);
        if (list->series.empty()) return fail({});
        // the key of NIfTI and NRRD is empty until they are read
        const auto chosen =
            std::ranges::find_if(list->series, [&series](const imaging::CtSeries& each) {
              return series.empty() || each.key.empty() || each.key == series;
            });
        if (chosen == list->series.end()) return seriesMissed();
        if (!chosen->obstacle.empty()) return fail(chosen->obstacle);
        read(*list, chosen->uid);
      });
}

void CtWork::read(const imaging::CtSeriesList& list, const std::string& uid)
{
  const Progress progress = begin();
  background_.run(
      "The CT",
      [list, uid,
       progress](const std::stop_token& stop) -> Result<std::shared_ptr<imaging::LoadedCt>> {
        auto loaded =
            imaging::readCt(list, uid, {[progress](double done) { progress->store(done); }, stop});
        if (!loaded) return loaded.error();
        return std::make_shared<imaging::LoadedCt>(*std::move(loaded));
      },
      [this](const Result<std::shared_ptr<imaging::LoadedCt>>& loaded) {
        end();
        if (!loaded) return fail(loaded.error().message);
        Q_EMIT ctRead(*loaded);
      });
}

void CtWork::readThumbnails(const imaging::CtSeriesList& list)
{
  background_.run(
      "The pictures of the series",
      [list](const std::stop_token& stop) -> Result<std::vector<imaging::CtThumbnail>> {
        return imaging::readThumbnails(list, thumbnail_px, {{}, stop});
      },
      [this](const Result<std::vector<imaging::CtThumbnail>>& pictures) {
        if (pictures) Q_EMIT thumbnailsRead(*pictures);
      });
}

void CtWork::measure(std::shared_ptr<const ct::CtVolume> volume, ct::MeasureRequest request)
{
  const Progress progress = begin();
  background_.run(
      "The measurement",
      [volume = std::move(volume), request = std::move(request), progress,
       measurement = measurement_](const std::stop_token& stop) mutable {
        request.onProgress = [progress](double done) { progress->store(done); };
        request.stop = stop;
        return measurement(*volume, request);
      },
      [this](const Result<ct::CochleaMeasures>& measures) {
        end();
        if (!measures) return fail(measures.error().message);
        Q_EMIT measured(*measures);
      });
}

void CtWork::cancel()
{
  if (!isBusy()) return;
  background_.cancel();
  isCanceled_ = true;
  end();
  fail({});
}

}  // namespace perilymph::gui
