// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/validation/Validation.h"

#include <algorithm>
#include <cmath>
#include <stop_token>

#include "experiment/LeastSquaresSpline.h"
#include "experiment/MeasuredInsertion.h"
#include "perilymph/analysis/RandomStream.h"
#include "perilymph/analysis/RunProgress.h"
#include "perilymph/foundation/InParallel.h"

namespace perilymph::validation {

namespace {

constexpr std::size_t pointsOfProfile = 166;
// Intervals of the raw record at the first rib: before contact, and around it.
constexpr Length ribFar = millimeters(1.0);
constexpr Length ribNear = millimeters(0.5);
// Where the raw records have their peak at the basal turn (Todd and Naghdy, section III).
constexpr Length rawPeakFrom = millimeters(9.0), rawPeakTo = millimeters(12.0);

/// Depth past the opening at which the published simulator's axis begins (Todd and Naghdy, section
/// III): its device's z was shifted by this length. Applied to the published model only.
constexpr Length publishedShift = millimeters(2.661);

bool isPublishedModel(const session::InsertionParameters& nominal)
{
  return nominal.model == mechanics::ModelKind::points;
}

/// Data kept of one insertion.
struct RunResult {
  std::vector<double> curve;  ///< Empty if it was incomplete.
  std::optional<IncompleteInsertion> incomplete;
  std::optional<double> rawPeak, beforeRib, ribPeak;
  std::uint64_t ticks = 0, ticksNotConverged = 0;
};

std::optional<Length> firstRib(const session::InsertionParameters& nominal)
{
  const auto& ribs = nominal.array.ribsFromTip;
  if (isPublishedModel(nominal) || ribs.empty() ||
      ribs.front() + ribNear > nominal.array.insertable)
    return std::nullopt;
  return ribs.front();
}

/// Beyond the end of the published axis, and beyond the first rib if there is one.
Length stopOf(const session::InsertionParameters& nominal)
{
  // The tip may be ahead of the crosshead, because the array bends outside; half a millimeter more
  // makes the last sample reach the end.
  Length stop = profileEnd() + millimeters(0.5);
  if (isPublishedModel(nominal)) stop = stop + publishedShift - nominal.startInside;
  if (const auto rib = firstRib(nominal))
    stop = std::max(stop, *rib + ribNear - nominal.startInside);
  return std::min(stop, nominal.array.insertable - nominal.startInside);
}

void keepRib(const MeasuredInsertion& measured, Length rib, RunResult& kept)
{
  double sum = 0.0;
  double count = 0.0;
  for (std::size_t i = 0; i < measured.depth.size(); ++i) {
    const double ahead = rib.si() - measured.depth[i];
    if (ahead <= ribFar.si() && ahead >= ribNear.si()) {
      sum += measured.force[i];
      count += 1.0;
    }
    if (std::fabs(ahead) < ribNear.si())
      kept.ribPeak = std::max(kept.ribPeak.value_or(measured.force[i]), measured.force[i]);
  }
  if (count > 0.0) kept.beforeRib = sum / count;
}

void keepRawPeak(const MeasuredInsertion& measured, RunResult& kept)
{
  for (std::size_t i = 0; i < measured.travel.size(); ++i)
    if (measured.travel[i] >= rawPeakFrom.si() && measured.travel[i] <= rawPeakTo.si())
      kept.rawPeak = std::max(kept.rawPeak.value_or(measured.force[i]), measured.force[i]);
}

Result<void> runOne(const ValidationRequest& request, SpreadSources sources, std::uint64_t number,
                    const std::shared_ptr<const anatomy::ScalaTympani>& anatomy,
                    const std::stop_token& stop, RunResult& kept)
{
  const DrawnInsertion drawn =
      drawInsertion(request.nominal, request.variability, sources, request.seed, number);
  auto measured =
      measure(drawn, anatomy, request.variability.samplePeriod, stopOf(drawn.parameters), stop);
  if (!measured) return measured.error();
  kept.ticks = measured->ticks;
  kept.ticksNotConverged = measured->ticksNotConverged;
  kept.incomplete = measured->incomplete;
  if (kept.incomplete) return {};
  if (isPublishedModel(drawn.parameters))
    for (std::size_t i = 0; i < measured->travel.size(); ++i)
      measured->travel[i] = measured->depth[i] - publishedShift.si();
  auto curve = resampled(measured->travel, measured->force, request.variability.knotSpacing);
  if (!curve)
    return Error{
        "Insertion %1 gave too few samples for its spline. Raise knot_spacing_mm or lower the "
        "speed.",
        number + 1};
  kept.curve = std::move(*curve);
  keepRawPeak(*measured, kept);
  if (const auto rib = firstRib(drawn.parameters)) keepRib(*measured, *rib, kept);
  return {};
}

/// The curves of the complete ones among some insertions.
std::vector<const std::vector<double>*> curvesOf(const std::vector<RunResult>& kept,
                                                 std::size_t first, std::size_t count)
{
  std::vector<const std::vector<double>*> curves;
  for (std::size_t i = first; i < first + count; ++i)
    if (!kept[i].incomplete) curves.push_back(&kept[i].curve);
  return curves;
}

/// Statistics over at least one curve at one point of the axis.
analysis::SampleStatistics statisticsAt(const std::vector<const std::vector<double>*>& curves,
                                        std::size_t point)
{
  std::vector<double> values(curves.size());
  for (std::size_t i = 0; i < curves.size(); ++i) values[i] = (*curves[i])[point];
  return analysis::statisticsOf(values);
}

/// Root mean square over travel of the standard deviation; 0 for fewer than two curves.
double spreadOf(const std::vector<const std::vector<double>*>& curves)
{
  if (curves.size() < 2) return 0.0;
  double squares = 0.0;
  for (std::size_t point = 0; point < pointsOfProfile; ++point) {
    const double standardDeviation = statisticsAt(curves, point).standardDeviation;
    squares += standardDeviation * standardDeviation;
  }
  return std::sqrt(squares / static_cast<double>(pointsOfProfile));
}

std::vector<AnchorComparison> compareAnchors(const analysis::Reference& experiment,
                                             const std::vector<ProfilePoint>& profile)
{
  std::vector<AnchorComparison> anchors;
  for (const analysis::PrintedForce& point : experiment.points) {
    const auto index =
        static_cast<std::size_t>(std::lround(point.travel / analysis::profileStep().si()));
    if (index >= profile.size()) continue;
    AnchorComparison anchor;
    anchor.experiment = point;
    anchor.simulator = profile[index].force;
    analysis::SampleStatistics printed{point.mean, point.standardDeviation, 0.0};
    if (experiment.insertions > 0.0)
      printed.standardError = point.standardDeviation / std::sqrt(experiment.insertions);
    anchor.difference = analysis::differenceOf(anchor.simulator, printed);
    anchor.isWithinStandardDeviation = std::fabs(anchor.difference.mean) <= point.standardDeviation;
    anchors.push_back(anchor);
  }
  return anchors;
}

std::vector<IntervalComparison> compareIntervals(const analysis::Reference& experiment,
                                                 const std::vector<ProfilePoint>& profile)
{
  std::vector<IntervalComparison> intervals;
  for (const analysis::PrintedInterval& printed : experiment.intervals) {
    const auto index =
        static_cast<std::size_t>(std::lround(printed.travel / analysis::profileStep().si()));
    if (index >= profile.size()) continue;
    const double found = profile[index].force.mean;
    analysis::SampleStatistics end{std::clamp(found, printed.low, printed.high),
                                   printed.standardDeviation, 0.0};
    if (experiment.insertions > 0.0)
      end.standardError = printed.standardDeviation / std::sqrt(experiment.insertions);
    const analysis::SampleStatistics difference = analysis::differenceOf(profile[index].force, end);
    intervals.push_back({printed, profile[index].force, difference.mean, difference.standardError});
  }
  return intervals;
}

std::optional<analysis::SampleStatistics> rawPeakOf(const ValidationRequest& request,
                                                    const std::vector<RunResult>& kept)
{
  std::vector<double> peaks;
  for (std::size_t i = 0; i < static_cast<std::size_t>(request.runs); ++i)
    if (kept[i].rawPeak) peaks.push_back(*kept[i].rawPeak);
  if (peaks.empty()) return std::nullopt;
  return analysis::statisticsOf(peaks);
}

std::optional<RibEntry> meetRib(const ValidationRequest& request,
                                const std::vector<RunResult>& kept)
{
  const auto rib = firstRib(request.nominal);
  if (!rib) return std::nullopt;
  std::vector<double> before, peak;
  for (std::size_t i = 0; i < static_cast<std::size_t>(request.runs); ++i) {
    if (!kept[i].beforeRib || !kept[i].ribPeak) continue;
    before.push_back(*kept[i].beforeRib);
    peak.push_back(*kept[i].ribPeak);
  }
  if (before.empty()) return std::nullopt;
  return RibEntry{rib->si(), analysis::statisticsOf(before), analysis::statisticsOf(peak)};
}

/// Sources that need insertions of their own; noise is added to a curve at rest instead.
std::vector<SpreadSource> mechanicalSources(const ValidationRequest& request)
{
  std::vector<SpreadSource> sources;
  for (const SpreadSource source : allSpreadSources)
    if (source != SpreadSource::noise &&
        (source != SpreadSource::curvature || request.nominal.array.hasStylet))
      sources.push_back(source);
  return sources;
}

/// Number of insertions with a single source.
std::size_t runsForSources(const ValidationRequest& request)
{
  const int asked = request.runsPerSource.value_or(std::max(10, request.runs / 10));
  return asked <= 0 ? 0 : static_cast<std::size_t>(std::max(2, asked));
}

/// Spread of the splines due to noise alone: noise does not affect the mechanics, so samples at
/// rest suffice.
double noiseSpread(const ValidationRequest& request, std::size_t count)
{
  const double way =
      request.nominal.speed.si() * request.variability.samplePeriod.si();  // between samples
  std::vector<RunResult> kept(count);
  for (std::size_t number = 0; number < count; ++number) {
    analysis::RandomStream noise(request.seed, number,
                                 static_cast<std::uint64_t>(SpreadSource::noise));
    std::vector<double> travel, force;
    for (double place = 0.0; place <= profileEnd().si(); place += way) {
      travel.push_back(place);
      force.push_back(request.variability.noiseDeviation.si() * noise.normal());
    }
    auto curve = resampled(travel, force, request.variability.knotSpacing);
    if (!curve) return 0.0;
    kept[number].curve = std::move(*curve);
  }
  return spreadOf(curvesOf(kept, 0, count));
}

std::vector<SourceSpread> sourceSpreads(const ValidationRequest& request,
                                        const std::vector<RunResult>& kept,
                                        std::size_t runsPerSource)
{
  std::vector<SourceSpread> spreads;
  std::size_t first = static_cast<std::size_t>(request.runs);
  for (const SpreadSource source : mechanicalSources(request)) {
    spreads.push_back({source, spreadOf(curvesOf(kept, first, runsPerSource)), 0.0});
    first += runsPerSource;
  }
  spreads.push_back({SpreadSource::noise, noiseSpread(request, runsPerSource), 0.0});
  double sum = 0.0;
  for (const SourceSpread& spread : spreads)
    sum += spread.standardDeviation * spread.standardDeviation;
  if (sum > 0.0)
    for (SourceSpread& spread : spreads)
      spread.fraction = spread.standardDeviation * spread.standardDeviation / sum;
  return spreads;
}

/// The largest local maximum of the mean curve before the basal turn, where the paper's experiment
/// has a small peak: near 4 mm in its raw record, near 6 mm in its spline, the dip near 8 mm. The
/// range is one millimeter wider on both sides. It counts if the force falls by more than noise
/// explains.
std::optional<analysis::CurvePoint> findEarlyPeak(const std::vector<analysis::CurvePoint>& curve)
{
  constexpr double minFall = 0.001;  // [N]
  const analysis::BasalTurn found =
      analysis::findBasalTurn(curve, {millimeters(3), millimeters(7), millimeters(9)});
  if (!found.peak || !found.dip || found.peak->force - found.dip->force < minFall)
    return std::nullopt;
  return found.peak;
}

}  // namespace

std::optional<std::vector<double>> resampled(const std::vector<double>& travel,
                                             const std::vector<double>& force, Length knotSpacing)
{
  const double end = profileEnd().si();
  const auto intervals =
      static_cast<std::size_t>(std::max(1L, std::lround(end / knotSpacing.si())));
  const auto spline = fitSpline(travel, force, 0.0, end, intervals);
  if (!spline) return std::nullopt;
  std::vector<double> values(pointsOfProfile);
  for (std::size_t i = 0; i < pointsOfProfile; ++i)
    values[i] = spline->at(static_cast<double>(i) * analysis::profileStep().si());
  return values;
}

Result<ValidationResult> validate(const ValidationRequest& request,
                                  const analysis::RunProgress& progress,
                                  const std::stop_token& stop)
{
  if (request.runs < 2)
    return Error{"A validation of %1 insertions has no spread; ask for at least 2.", request.runs};
  std::shared_ptr<const anatomy::ScalaTympani> anatomy = request.anatomy;
  if (!anatomy) {
    auto built = session::buildAnatomy(request.nominal);
    if (!built) return built.error();
    anatomy = *built;
  }

  const auto runs = static_cast<std::size_t>(request.runs);
  const std::size_t runsPerSource = runsForSources(request);
  const std::vector<SpreadSource> alone = mechanicalSources(request);
  const std::size_t all = runs + alone.size() * runsPerSource;
  std::vector<RunResult> kept(all);
  const auto work = [&](std::size_t piece, const std::stop_token& ending) {
    SpreadSources sources = SpreadSources::all();
    std::size_t number = piece;
    if (piece >= runs) {
      sources = SpreadSources::only(alone[(piece - runs) / runsPerSource]);
      number = (piece - runs) % runsPerSource;
    }
    const auto done = runOne(request, sources, number, anatomy, ending, kept[piece]);
    if (done && piece < runs && !kept[piece].incomplete && request.onCurve)
      request.onCurve(kept[piece].curve);
    return done;
  };
  const auto done = doInParallel(
      all, request.jobs, work,
      [&](std::size_t count) {
        if (progress) progress(count, all);
      },
      stop);
  if (!done) return done.error();

  ValidationResult result;
  result.runs = request.runs;
  result.seed = request.seed;
  for (std::size_t i = 0; i < runs; ++i)
    if (kept[i].incomplete) result.incomplete.push_back(*kept[i].incomplete);
  const auto curves = curvesOf(kept, 0, runs);
  if (curves.size() < 2)
    return Error{
        "%1 A mean needs at least 2 of them. Ask for more runs, or name a scenario whose "
        "insertions reach the end.%2",
        completionSentence(request.runs, result.incomplete),
        (result.incomplete.empty() ? "" : " " + result.incomplete.front().fault)};
  std::vector<analysis::CurvePoint> mean;
  for (std::size_t point = 0; point < pointsOfProfile; ++point) {
    const double travel = static_cast<double>(point) * analysis::profileStep().si();
    result.profile.push_back({travel, statisticsAt(curves, point)});
    mean.push_back({travel, result.profile.back().force.mean});
  }
  for (const RunResult& each : kept) {
    result.ticks += each.ticks;
    result.ticksNotConverged += each.ticksNotConverged;
  }
  result.anchors = compareAnchors(request.experiment, result.profile);
  result.intervals = compareIntervals(request.experiment, result.profile);
  result.basalTurn = analysis::findBasalTurn(mean);
  result.rawPeak = rawPeakOf(request, kept);
  result.earlyPeak = findEarlyPeak(mean);
  result.rib = meetRib(request, kept);
  result.standardDeviation = spreadOf(curves);
  if (runsPerSource > 0) result.spreads = sourceSpreads(request, kept, runsPerSource);
  return result;
}

}  // namespace perilymph::validation
