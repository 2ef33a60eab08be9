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
// where reading and measuring end in the time until the ear is carried over (choice, low)
constexpr double readUntil = 0.2, measureUntil = 0.7;

using Report = std::function<void(OutcomeStep, double)>;

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
                                    std::optional<anatomy::Side> side, const Report& report,
                                    const std::stop_token& stop)
{
  report(OutcomeStep::readBefore, 0.0);
  const auto list = imaging::findSeries(before.place, {{}, stop});
  if (!list) return list.error();
  const auto chosen = std::ranges::find_if(list->series, [&](const imaging::CtSeries& each) {
    return each.key.empty() || each.key == before.series;
  });
  if (chosen == list->series.end())
    return Error{"The CT before surgery is no longer in %1.", before.place};
  auto loaded = imaging::readCt(
      *list, chosen->uid,
      {[&report](double done) { report(OutcomeStep::readBefore, readUntil * done); }, stop});
  if (!loaded) return loaded.error();
  if (loaded->series.key != before.series)
    return Error{"The CT before surgery is no longer in %1.", before.place};
  ct::MeasureRequest request;
  request.side = side;
  request.stop = stop;
  request.onProgress = [&report](double done) {
    report(OutcomeStep::measureBefore, readUntil + (measureUntil - readUntil) * done);
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
                       const Report& report, const std::stop_token& stop)
{
  Sentence note;
  if (before) {
    const auto earlier = earlierVolume(finder, *before, side, report, stop);
    if (stop.stop_requested()) return Error{"The search was canceled."};
    const auto onProgress = [&report](double done) {
      report(OutcomeStep::carryOver, measureUntil + (1.0 - measureUntil) * done);
    };
    Result<outcome::Ear> ear = earlier ? finder.registeredEar(after, earlier->ct.volume,
                                                              earlier->measures, stop, onProgress)
                                       : Result<outcome::Ear>(earlier.error());
    if (ear) return FoundEar{std::make_shared<const outcome::Ear>(*std::move(ear)), {}};
    if (stop.stop_requested()) return ear.error();
    note = ear.error().message;
  }
  ct::MeasureRequest request;
  request.side = side;
  request.stop = stop;
  report(OutcomeStep::measureHere, 0.0);
  request.onProgress = [&report](double done) { report(OutcomeStep::measureHere, done); };
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
    if (progress_) Q_EMIT progressed(progress_->step.load(), progress_->fraction.load());
  });
}

OutcomeWork::Progress OutcomeWork::begin(OutcomeStep step)
{
  progress_ = std::make_shared<State>();
  progress_->step = step;
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
  const Progress progress = begin(before ? OutcomeStep::readBefore : OutcomeStep::measureHere);
  background_.run(
      "The measurement",
      [after, before, side, progress, finder = finder_](const std::stop_token& stop) {
        const Report report = [progress](OutcomeStep step, double done) {
          progress->step = step;
          progress->fraction = done;
        };
        return earOf(finder, *after, before, side, report, stop);
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
  const Progress progress = begin(OutcomeStep::findContacts);
  background_.run(
      "The search for the contacts",
      [after, ear, request = std::move(request), progress,
       find = finder_.findContacts](const std::stop_token& stop) mutable
      -> Result<std::shared_ptr<const outcome::FoundArray>> {
        request.onProgress = [progress](double done) { progress->fraction = done; };
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
