// SPDX-License-Identifier: BSD-3-Clause

// The three figures of the paper, with current data.

#include <algorithm>

#include "perilymph/figures/Strings.h"
#include "perilymph/validation/ValidationReport.h"

namespace perilymph::validation {

using figures::Figure;
using figures::FigureAxis;
using figures::FigureBand;
using figures::FigureCurve;
using figures::FigureValues;
using figures::fixed;
using figures::Ink;
using figures::MarkerShape;
namespace ink = figures::ink;

namespace {

double mm(double travel) { return inMillimeters(meters(travel)); }
double mN(double force) { return inMillinewtons(newtons(force)); }

FigureAxis travelAxis() { return {Sentence{"travel, mm"}, 0.0, 17.0, 2.0, 0}; }

FigureAxis forceAxis(double highest)
{
  FigureAxis axis{Sentence{"insertion force, mN"}, 0.0, 200.0, 50.0, 0};
  while (axis.high < highest) axis.high += axis.tick;
  return axis;
}

/// A level at what surgeons feel; none where the reference is missing.
void addFelt(Figure& figure, Phrase label, bool isBothWays)
{
  const Result<Force> felt = analysis::forceFeltBySurgeons();
  if (!felt) return;
  figure.levels.push_back(
      {Sentence(label, {fixed(inMillinewtons(*felt), 1)}), inMillinewtons(*felt), ink::gray, 3.0});
  if (isBothWays) figure.levels.push_back({"", -inMillinewtons(*felt), ink::gray, 3.0});
}

FigureValues printed(const analysis::Reference& reference, Sentence label, const Ink& color,
                     MarkerShape shape)
{
  FigureValues values;
  values.label = std::move(label);
  values.ink = color;
  values.shape = shape;
  for (const analysis::PrintedForce& point : reference.points) {
    values.x.push_back(mm(point.travel));
    values.y.push_back(mN(point.mean));
    values.low.push_back(mN(point.mean - point.standardDeviation));
    values.high.push_back(mN(point.mean + point.standardDeviation));
  }
  return values;
}

}  // namespace

Figure experimentFigure(const analysis::Reference& experiment,
                        const analysis::Reference& publishedSimulator)
{
  Figure figure;
  figure.title = Sentence{"Published forces"};
  figure.x = travelAxis();
  figure.y = forceAxis(200.0);
  figure.values.push_back(
      printed(experiment, Sentence{"experiment, mean ± SD"}, ink::black, MarkerShape::disk));
  figure.values.push_back(printed(publishedSimulator, Sentence{"published simulator, mean ± SD"},
                                  ink::green, MarkerShape::square));
  figure.notes = {
      Sentence{"Todd and Naghdy: Nucleus 24 Contour, synthetic scala tympani, soap, 2.0 mm/s."},
      Sentence{"Values between points were not reported."}};
  return figure;
}

Figure simulationFigure(const ValidationResult& result, const analysis::Reference& experiment)
{
  Figure figure;
  figure.title = experiment.kind == "experiment"
                     ? Sentence{"Simulated insertions and the published experiment"}
                     : Sentence{"Simulated insertions and the published %1", experiment.kind};
  figure.x = travelAxis();
  FigureBand spread{Sentence{"± SD between insertions"}, {}, {}, {}, ink::tint(ink::blue, 0.18)};
  FigureBand confidence{
      Sentence{"95 % confidence interval of the mean"}, {}, {}, {}, ink::tint(ink::blue, 0.45)};
  const int completed = result.runs - static_cast<int>(result.incomplete.size());
  FigureCurve mean{
      Sentence{"mean of %1 simulated insertions", completed}, {}, {}, ink::blue, 1.6, 0.0};
  double highest = 0.0;
  for (const ProfilePoint& point : result.profile) {
    for (auto* x : {&spread.x, &confidence.x, &mean.x}) x->push_back(mm(point.travel));
    mean.y.push_back(mN(point.force.mean));
    spread.low.push_back(mN(point.force.mean - point.force.standardDeviation));
    spread.high.push_back(mN(point.force.mean + point.force.standardDeviation));
    confidence.low.push_back(mN(point.force.low95()));
    confidence.high.push_back(mN(point.force.high95()));
    highest = std::max(highest, spread.high.back());
  }
  figure.y = forceAxis(highest);
  figure.bands = {spread, confidence};
  figure.curves = {mean};
  addFelt(figure, Phrase{"perception threshold, median %1 mN"}, false);
  figure.values.push_back(printed(experiment, experiment.label, ink::black, MarkerShape::disk));
  figure.notes = {
      Sentence{"Seed %1; least-squares spline through each insertion, resampled every 0.1 mm.",
               result.seed}};
  if (!result.incomplete.empty())
    figure.notes.push_back(completionSentence(result.runs, result.incomplete));
  return figure;
}

Figure calibrationFigure(const CalibrationResult& calibration,
                         const analysis::Reference& experiment)
{
  analysis::Reference used = experiment, others = experiment;
  used.points.clear();
  others.points.clear();
  for (const analysis::PrintedForce& point : experiment.points) {
    bool isUsed = false;
    for (const session::FittedForce& force : calibration.calibration.forces)
      isUsed = isUsed || force.travel == point.travel;
    (isUsed ? used : others).points.push_back(point);
  }
  Figure figure = simulationFigure(calibration.fitted, experiment);
  figure.title = Sentence{"Calibrated insertions: fitted and other forces"};
  figure.values = {
      printed(used, Sentence{"experiment, mean ± SD, used for calibration"}, ink::vermilion,
              MarkerShape::diamond),
      printed(others, Sentence{"experiment, mean ± SD, not used"}, ink::black, MarkerShape::disk)};
  const session::Calibration& fit = calibration.calibration;
  figure.notes = {Sentence{"Stiffness scale %1 ± %2.", fixed(fit.stiffnessScale.value, 3),
                           fixed(fit.stiffnessScale.standardDeviation, 3)}};
  return figure;
}

Figure differenceFigure(const ValidationResult& result,
                        const analysis::Reference& publishedDifference)
{
  Figure figure;
  figure.title = Sentence{"Simulator minus experiment"};
  figure.x = travelAxis();
  FigureValues ours;
  ours.label = Sentence{"this simulator, 95 % confidence interval"};
  ours.ink = ink::blue;
  double lowest = -80.0, highest = 80.0;
  for (const AnchorComparison& anchor : result.anchors) {
    ours.x.push_back(mm(anchor.experiment.travel));
    ours.y.push_back(mN(anchor.difference.mean));
    ours.low.push_back(mN(anchor.difference.low95()));
    ours.high.push_back(mN(anchor.difference.high95()));
    lowest = std::min(lowest, ours.low.back());
    highest = std::max(highest, ours.high.back());
  }
  FigureValues theirs;
  theirs.label =
      Sentence{"published simulator, 95 % confidence interval where reported (sign corrected)"};
  theirs.ink = ink::green;
  theirs.shape = MarkerShape::square;
  for (const analysis::PrintedDifference& difference : publishedDifference.differences) {
    theirs.x.push_back(mm(difference.travel));
    theirs.y.push_back(mN(difference.mean));
    theirs.low.push_back(mN(difference.low.value_or(difference.mean)));
    theirs.high.push_back(mN(difference.high.value_or(difference.mean)));
  }
  figure.y = figures::axisOver(Sentence{"difference of mean insertion force, mN"}, lowest, highest);
  addFelt(figure, Phrase{"perception threshold ± %1 mN"}, true);
  figure.values = {theirs, ours};
  figure.notes = {Sentence{
      "Shown only where the experiment was reported; its means are from about 11 insertions."}};
  return figure;
}

}  // namespace perilymph::validation
