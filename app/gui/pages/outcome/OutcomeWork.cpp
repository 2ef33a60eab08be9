// SPDX-License-Identifier: BSD-3-Clause
#include "gui/pages/outcome/OutcomeWork.h"

#include <algorithm>
#include <stop_token>
#include <utility>

#include "gui/text/DataText.h"
#include "perilymph/imaging/CtSeries.h"

namespace perilymph::gui {

namespace {

constexpr int report_ms = 100;
// parts of the time until the ear is carried over (choice; the registration reports none)
constexpr double readPart = 0.3, measurePart = 0.5;

/// What an ear is found from, and why not from the CT before surgery.
struct FoundEar {
  OutcomeWork::SharedEar ear;
  Sentence note;
};

struct EarlierVolume {
  imaging::LoadedCt ct;
  ct::CochleaMeasures measures;
};

/// Reads and measures the CT before surgery: from its landmarks by hand, if it has them.
Result<EarlierVolume> earlierVolume(const OutcomeFinder& finder, const EarlierCt& before,
                                    std::optional<anatomy::Side> side,
                                    const std::function<void(double)>& onProgress,
                                    const std::stop_token& stop)
{
  const auto list = imaging::findSeries(before.place, {{}, stop});
  if (!list) return list.error();
  const auto chosen = std::ranges::find_if(list->series, [&](const imaging::CtSeries& each) {
    return each.key.empty() || each.key == before.series;
  });
  if (chosen == list->series.end())
    return Error{"The CT before surgery is no longer in %1.", before.place};
  auto loaded = imaging::readCt(
      *list, chosen->uid, {[&onProgress](double done) { onProgress(readPart * done); }, stop});
  if (!loaded) return loaded.error();
  if (loaded->series.key != before.series)
    return Error{"The CT before surgery is no longer in %1.", before.place};
  ct::MeasureRequest request;
  request.side = side;
  request.stop = stop;
  request.onProgress = [&onProgress](double done) {
    onProgress(readPart + (measurePart - readPart) * done);
  };
  auto measures = finder.measure(loaded->volume, request);
  if (measures && !before.marks.isEmpty()) {
    ct::Marks all = ct::marksOf(*measures);
    for (std::size_t k = 0; k < ct::markCount; ++k)
      if (before.marks.points_P[k]) all.points_P[k] = before.marks.points_P[k];
    request.side.reset();
    request.marks = before.marks;
    request.click_P = all.inside_P();
    measures = finder.measure(loaded->volume, request);
  }
  if (!measures) return measures.error();
  if (measures->has(ct::Flag::metal))
    return Error{
        "%1 shows metal in the cochlea, so that it is no CT before surgery: the ear is measured in "
        "the CT after it.",
        before.place};
  return EarlierVolume{*std::move(loaded), *std::move(measures)};
}

Result<FoundEar> earOf(const OutcomeFinder& finder, const ct::CtVolume& after,
                       const std::optional<EarlierCt>& before, std::optional<anatomy::Side> side,
                       const std::function<void(double)>& onProgress, const std::stop_token& stop)
{
  Sentence note;
  if (before) {
    const auto earlier = earlierVolume(finder, *before, side, onProgress, stop);
    if (stop.stop_requested()) return Error{"The search was canceled."};
    Result<outcome::Ear> ear =
        earlier ? finder.registeredEar(after, earlier->ct.volume, earlier->measures, stop)
                : Result<outcome::Ear>(earlier.error());
    if (ear) return FoundEar{std::make_shared<const outcome::Ear>(*std::move(ear)), {}};
    note = ear.error().message;
  }
  ct::MeasureRequest request;
  request.side = side;
  request.stop = stop;
  request.onProgress = onProgress;
  auto ear = finder.measuredEar(after, request);
  if (!ear) return ear.error();
  return FoundEar{std::make_shared<const outcome::Ear>(*std::move(ear)), note};
}

}  // namespace

OutcomeFinder engineFinder()
{
  return {ct::measureCochlea, outcome::registeredEar, outcome::measuredEar, outcome::findContacts};
}

OutcomeWork::OutcomeWork(QObject* parent)
    : QObject(parent), finder_(engineFinder()), background_(this)
{
  timer_.setInterval(report_ms);
  connect(&timer_, &QTimer::timeout, this, [this] {
    if (progress_) Q_EMIT progressed(progress_->load());
  });
}

OutcomeWork::Progress OutcomeWork::begin()
{
  progress_ = std::make_shared<std::atomic<double>>(0.0);
  timer_.start();
  return progress_;
}

void OutcomeWork::end()
{
  timer_.stop();
  progress_.reset();
}

void OutcomeWork::findEar(const Volume& after, const std::optional<EarlierCt>& before,
                          std::optional<anatomy::Side> side)
{
  const Progress progress = begin();
  background_.run(
      "The measurement",
      [after, before, side, progress, finder = finder_](const std::stop_token& stop) {
        return earOf(
            finder, *after, before, side, [progress](double done) { progress->store(done); }, stop);
      },
      [this](const Result<FoundEar>& ear) {
        end();
        if (!ear) return failed(dataText(ear.error().message));
        Q_EMIT earFound(ear->ear, dataText(ear->note));
      });
}

void OutcomeWork::findContacts(const Volume& after, const SharedEar& ear,
                               outcome::ContactsRequest request)
{
  const Progress progress = begin();
  background_.run(
      "The search for the contacts",
      [after, ear, request = std::move(request), progress,
       find = finder_.findContacts](const std::stop_token& stop) mutable
      -> Result<std::shared_ptr<const outcome::FoundArray>> {
        request.onProgress = [progress](double done) { progress->store(done); };
        request.stop = stop;
        auto array = find(*after, *ear, request);
        if (!array) return array.error();
        return std::make_shared<const outcome::FoundArray>(*std::move(array));
      },
      [this](const Result<std::shared_ptr<const outcome::FoundArray>>& array) {
        end();
        if (!array) return failed(dataText(array.error().message));
        Q_EMIT found(*array);
      });
}

void OutcomeWork::cancel()
{
  if (!isBusy()) return;
  background_.cancel();
  end();
  Q_EMIT failed({});
}

}  // namespace perilymph::gui
