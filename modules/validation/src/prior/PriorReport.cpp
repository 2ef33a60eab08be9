// SPDX-License-Identifier: BSD-3-Clause

// Output of the prior-predictive test.

#include <nlohmann/json.hpp>

#include "ValidationColumns.h"
#include "perilymph/foundation/Version.h"
#include "perilymph/session/Csv.h"
#include "perilymph/validation/PriorPredictive.h"

namespace perilymph::validation {

namespace {

using session::shortestDecimal;

double inMilli(double force) { return 1e3 * force; }

}  // namespace

std::string priorCsv(const std::vector<RepeatedExperiment>& repetitions)
{
  std::string csv = headerOf(priorColumns()) + "\n";
  for (const RepeatedExperiment& each : repetitions) {
    csv += std::to_string(each.number) + "," + each.reason;
    for (const double value : each.inputs) csv += "," + shortestDecimal(value);
    csv += "," + shortestDecimal(each.scale);
    for (const double force : each.force) csv += "," + shortestDecimal(inMilli(force));
    for (std::size_t k = 1; k < each.slope.size(); ++k) csv += "," + shortestDecimal(each.slope[k]);
    csv += "\n";
  }
  return csv;
}

std::string priorSummaryCsv(const PriorSummary& summary)
{
  std::string csv = headerOf(priorSummaryColumns()) + "\n";
  for (const PredictedAnchor& anchor : summary.anchors) {
    csv += shortestDecimal(anchor.travel_mm);
    for (const double force :
         {anchor.low, anchor.high, anchor.standardError, anchor.mean, anchor.deviation,
          anchor.low90, anchor.high90, anchor.low90WithError, anchor.high90WithError})
      csv += "," + shortestDecimal(inMilli(force));
    csv += "," + shortestDecimal(anchor.rank) + "," + shortestDecimal(anchor.rankWithError) + "," +
           (anchor.isInside ? "true" : "false");
    for (const double value : anchor.correlation) csv += "," + shortestDecimal(value);
    csv += "\n";
  }
  return csv;
}

std::string priorJson(const PriorRequest& request, const PriorSummary& summary)
{
  nlohmann::ordered_json page;
  page["version"] = version();
  page["seed"] = request.seed;
  page["repetitions"] = summary.counted;
  page["left_out"] = summary.leftOut;
  page["ranges"] = request.ranges.label;
  for (std::size_t i = 0; i < inputCount; ++i) {
    const InputRange& range = request.ranges.inputs[i];
    page["inputs"].push_back({{"input", inputNames[i]},
                              {"low", range.low},
                              {"high", range.high},
                              {"law", range.isLogarithmic ? "log" : "uniform"},
                              {"declared", range.declared},
                              {"source", range.source}});
  }
  for (const PredictedAnchor& anchor : summary.anchors) {
    nlohmann::ordered_json row = {
        {"travel_mm", anchor.travel_mm},
        {"experiment_N", {anchor.low, anchor.high}},
        {"experiment_sem_N", anchor.standardError},
        {"mean_N", anchor.mean},
        {"sd_N", anchor.deviation},
        {"band90_N", {anchor.low90, anchor.high90}},
        {"band90_with_error_N", {anchor.low90WithError, anchor.high90WithError}},
        {"rank", anchor.rank},
        {"rank_with_error", anchor.rankWithError},
        {"is_inside", anchor.isInside}};
    for (std::size_t i = 0; i < inputCount; ++i)
      row["rank_correlation"][inputNames[i]] = anchor.correlation[i];
    page["forces"].push_back(row);
  }
  for (const JointTest& joint : summary.joint)
    page["joint"].push_back({{"correlation_of_errors", joint.correlation},
                             {"squared_distance", joint.distance},
                             {"p", joint.pValue},
                             {"p_counted", joint.counted}});
  return page.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

}  // namespace perilymph::validation
