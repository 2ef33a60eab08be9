// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/validation/ValidationReport.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "ValidationColumns.h"
#include "perilymph/analysis/PhysicalRanges.h"
#include "perilymph/analysis/RoundedTravel.h"
#include "perilymph/figures/Strings.h"
#include "perilymph/foundation/Version.h"
#include "perilymph/session/Csv.h"

namespace perilymph::validation {

namespace {

using Json = nlohmann::ordered_json;

// Acceptance limits. Half of the published simulator's maximum difference, 0.0536 N; what surgeons
// feel (analysis::forceFeltBySurgeons); positions to a half and a third of the distance between the
// experiment's peak and dip and those of the published simulator.
constexpr double maxDifference = 0.027;
constexpr Length peakSlack = millimeters(0.8);
constexpr Length dipSlack = millimeters(0.6);

std::string forceNumber(double force) { return figures::fixed(inMillinewtons(newtons(force)), 1); }

Sentence forceText(double force) { return Sentence{"%1 mN", forceNumber(force)}; }

std::string number_mm(double travel) { return figures::fixed(inMillimeters(meters(travel)), 1); }

Sentence mm(double travel) { return Sentence{"%1 mm", number_mm(travel)}; }

Sentence rangeText(double low, double high)
{
  return Sentence{"%1 to %2", forceNumber(low), forceText(high)};
}

/// A feature of a printed curve, which the reference's file names.
Sentence featureName(const std::string& feature)
{
  static constexpr Phrase known[] = {Phrase{"peak"}, Phrase{"dip"}, Phrase{"maximum"},
                                     Phrase{"end"}};
  for (const Phrase& phrase : known)
    if (feature == phrase.english()) return Sentence(phrase);
  return feature;
}

/// The spread at one printed value: each is judged, because a mean over them would let one that is
/// too wide make up for others that are too narrow.
Verdict deviationVerdict(const AnchorComparison& anchor, double insertions)
{
  const double found = anchor.simulator.standardDeviation;
  const Range wanted = deviationsBehind(anchor.experiment.standardDeviation, insertions);
  return {Sentence{"standard deviation at %1, %2", mm(anchor.experiment.travel),
                   featureName(anchor.experiment.feature)},
          forceText(found), rangeText(wanted.low, wanted.high), analysis::isWithin(found, wanted)};
}

Verdict placeVerdict(const Sentence& what, const std::optional<analysis::CurvePoint>& found,
                     const analysis::PrintedForce* wanted, Length slack)
{
  Verdict verdict;
  verdict.what = what;
  verdict.found = found ? mm(found->travel) : Sentence{"none"};
  if (!wanted) return verdict;
  verdict.wanted = Sentence{"%1 ± %2", mm(wanted->travel), mm(slack.si())};
  // Travels are multiples of 0.1 mm with rounding errors.
  verdict.isMet = found && std::fabs(found->travel - wanted->travel) <= slack.si() + 1e-9;
  return verdict;
}

/// Half width of the differences of two means that 95 % of right models have; of an experiment whose
/// number of insertions is unknown, its standard deviation.
double halfWidthOf(double standardError, double deviation, double insertions)
{
  return insertions >= 2.0 ? halfWidth95 * standardError : deviation;
}

/// A mean of the raw records; the printed range is its mean ± standard deviation.
Verdict rangeVerdict(const Sentence& what, const std::optional<analysis::SampleStatistics>& found,
                     const analysis::PrintedRange* wanted, double insertions)
{
  Verdict verdict;
  verdict.what = what;
  verdict.found = found ? forceText(found->mean) : Sentence{"none"};
  if (!wanted) return verdict;
  const double deviation = 0.5 * (wanted->high - wanted->low);
  const analysis::SampleStatistics printed{0.5 * (wanted->low + wanted->high), deviation,
                                           deviation / std::sqrt(std::max(1.0, insertions))};
  const analysis::SampleStatistics difference =
      analysis::differenceOf(found.value_or(printed), printed);
  const double half = halfWidthOf(difference.standardError, deviation, insertions);
  verdict.wanted = Sentence{"%1 ± %2", forceNumber(printed.mean), forceText(half)};
  verdict.isMet = found && std::fabs(difference.mean) <= half;
  return verdict;
}

void addRow(std::string& csv, double travel, const analysis::SampleStatistics& force)
{
  csv += session::shortestDecimal(analysis::roundedMillimeters(travel));
  for (const double value :
       {force.mean, force.standardDeviation, force.standardError, force.low95(), force.high95()})
    csv += "," + session::shortestDecimal(value);
  csv += "\n";
}

Json json(const std::optional<analysis::CurvePoint>& point)
{
  if (!point) return nullptr;
  return {{"travel_mm", analysis::roundedMillimeters(point->travel)}, {"force_N", point->force}};
}

Json json(const analysis::SampleStatistics& statistics)
{
  return {{"mean_N", statistics.mean},
          {"sd_N", statistics.standardDeviation},
          {"sem_N", statistics.standardError},
          {"ci95_low_N", statistics.low95()},
          {"ci95_high_N", statistics.high95()}};
}

}  // namespace

std::vector<Verdict> verdictsOf(const ValidationResult& result,
                                const analysis::Reference& experiment)
{
  std::vector<Verdict> verdicts;
  for (const AnchorComparison& anchor : result.anchors) {
    const analysis::PrintedForce& printed = anchor.experiment;
    const double half = halfWidthOf(anchor.difference.standardError, printed.standardDeviation,
                                    experiment.insertions);
    verdicts.push_back(
        {Sentence{"mean force at %1, %2", mm(printed.travel), featureName(printed.feature)},
         forceText(anchor.simulator.mean),
         Sentence{"%1 ± %2", forceNumber(printed.mean), forceText(half)},
         std::fabs(anchor.difference.mean) <= half});
  }
  for (const IntervalComparison& interval : result.intervals) {
    const analysis::PrintedInterval& printed = interval.experiment;
    const double half =
        halfWidthOf(interval.standardError, printed.standardDeviation, experiment.insertions);
    verdicts.push_back({Sentence{"mean force at %1, %2", mm(printed.travel), Sentence{"derived"}},
                        forceText(interval.simulator.mean),
                        rangeText(printed.low - half, printed.high + half),
                        std::fabs(interval.difference) <= half});
  }
  const Agreement agreement = agreementOf(result);
  const double largest = agreement.largest;
  verdicts.push_back({Sentence{"largest difference of the predicted"}, forceText(largest),
                      Sentence{"at most %1", forceText(maxDifference)}, largest <= maxDifference});
  if (const Result<Force> felt = analysis::forceFeltBySurgeons())
    verdicts.push_back({Sentence{"largest difference below perception"}, forceText(largest),
                        Sentence{"at most %1", forceText(felt->si())}, largest <= felt->si()});
  if (agreement.degreesOfFreedom > 0)
    verdicts.push_back({Sentence{"p of the predicted forces"},
                        Sentence{"%1 (chi-square %2)", figures::fixed(agreement.pValue, 4),
                                 figures::fixed(agreement.chiSquare, 1)},
                        Sentence{"at least 0.05"}, agreement.pValue >= 0.05});
  verdicts.push_back(placeVerdict(Sentence{"position of the basal-turn peak"},
                                  result.basalTurn.peak, experiment.find("peak"), peakSlack));
  verdicts.push_back(placeVerdict(Sentence{"position of the following dip"}, result.basalTurn.dip,
                                  experiment.find("dip"), dipSlack));
  verdicts.push_back({Sentence{"small early peak"},
                      result.earlyPeak ? mm(result.earlyPeak->travel) : Sentence{"none"},
                      Sentence{"between 3 and 7 mm"}, result.earlyPeak.has_value()});
  std::optional<analysis::SampleStatistics> before, peak;
  if (result.rib) {
    before = result.rib->before;
    peak = result.rib->peak;
  }
  const auto addRaw = [&](const Sentence& what,
                          const std::optional<analysis::SampleStatistics>& found,
                          const char* range) {
    verdicts.push_back(
        rangeVerdict(what, found, experiment.findRange(range), experiment.insertions));
  };
  addRaw(Sentence{"mean raw force at the basal turn"}, result.rawPeak,
         "basal-turn peak, raw, 9 to 12 mm");
  addRaw(Sentence{"mean raw force just before the first rib"}, before,
         "just before the first rib, raw");
  addRaw(Sentence{"mean raw force at the first rib"}, peak, "first rib, raw");
  if (experiment.insertions >= 2.0)
    for (const AnchorComparison& anchor : result.anchors)
      verdicts.push_back(deviationVerdict(anchor, experiment.insertions));
  return verdicts;
}

std::string profileCsv(const ValidationResult& result)
{
  std::string csv = headerOf(forceColumns()) + "\n";
  for (const ProfilePoint& point : result.profile) addRow(csv, point.travel, point.force);
  return csv;
}

std::string differenceCsv(const ValidationResult& result)
{
  std::string csv = headerOf(forceColumns()) + "\n";
  for (const AnchorComparison& anchor : result.anchors)
    addRow(csv, anchor.experiment.travel, anchor.difference);
  return csv;
}

std::string summaryJson(const ValidationRequest& request, const ValidationResult& result)
{
  Json page;
  page["version"] = version();
  page["runs"] = result.runs;
  page["completed"] = result.runs - static_cast<int>(result.incomplete.size());
  page["incomplete"] = Json::array();
  for (const IncompleteInsertion& each : result.incomplete)
    page["incomplete"].push_back({{"insertion", each.number},
                                  {"end", nameOf(each.end)},
                                  {"max_depth_mm", inMillimeters(meters(each.maxDepth))},
                                  {"crosshead_mm", inMillimeters(meters(each.crosshead))},
                                  {"max_force_N", each.maxForce},
                                  {"fault", each.fault}});
  page["seed"] = result.seed;
  page["scenario"] = request.nominal.name;
  page["array"] = request.nominal.array.name;
  page["variability"] = request.variability.label;
  for (const auto& [table, source] : request.variability.provenance)
    page["variability_sources"][table] = source;
  page["experiment"] = request.experiment.source;
  page["experiment_insertions"] = request.experiment.insertions;
  page["ticks"] = result.ticks;
  page["ticks_not_converged"] = result.ticksNotConverged;
  page["basal_turn_peak"] = json(result.basalTurn.peak);
  page["basal_turn_dip"] = json(result.basalTurn.dip);
  page["early_peak"] = json(result.earlyPeak);
  page["anchors"] = Json::array();
  for (const AnchorComparison& anchor : result.anchors)
    page["anchors"].push_back(
        {{"travel_mm", analysis::roundedMillimeters(anchor.experiment.travel)},
         {"feature", anchor.experiment.feature},
         {"experiment_mean_N", anchor.experiment.mean},
         {"experiment_sd_N", anchor.experiment.standardDeviation},
         {"simulator", json(anchor.simulator)},
         {"difference", json(anchor.difference)},
         {"within_1_sd", anchor.isWithinStandardDeviation},
         {"mean_within_95",
          std::fabs(anchor.difference.mean) <= halfWidth95 * anchor.difference.standardError}});
  page["intervals"] = Json::array();
  for (const IntervalComparison& interval : result.intervals)
    page["intervals"].push_back(
        {{"travel_mm", analysis::roundedMillimeters(interval.experiment.travel)},
         {"experiment_low_N", interval.experiment.low},
         {"experiment_high_N", interval.experiment.high},
         {"simulator", json(interval.simulator)},
         {"difference_N", interval.difference}});
  const Agreement agreement = agreementOf(result);
  page["predicted"] = {{"largest_difference_N", agreement.largest},
                       {"chi_square", agreement.chiSquare},
                       {"degrees_of_freedom", agreement.degreesOfFreedom},
                       {"p", agreement.pValue}};
  if (result.rawPeak) page["raw_basal_turn_peak"] = json(*result.rawPeak);
  if (result.rib)
    page["first_rib"] = {{"depth_mm", analysis::roundedMillimeters(result.rib->depth)},
                         {"before", json(result.rib->before)},
                         {"peak", json(result.rib->peak)}};
  page["rms_sd_N"] = result.standardDeviation;
  page["spread"] = Json::array();
  for (const SourceSpread& spread : result.spreads)
    page["spread"].push_back({{"source", spreadSourceName(spread.source)},
                              {"rms_sd_alone_N", spread.standardDeviation},
                              {"fraction_of_variance", spread.fraction}});
  page["verdicts"] = Json::array();
  for (const Verdict& verdict : verdictsOf(result, request.experiment))
    page["verdicts"].push_back({{"what", verdict.what},
                                {"found", verdict.found},
                                {"wanted", verdict.wanted},
                                {"met", verdict.isMet}});
  return page.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace perilymph::validation
