// SPDX-License-Identifier: BSD-3-Clause
#include <nlohmann/json.hpp>

#include "ValidationColumns.h"
#include "perilymph/foundation/CsvField.h"
#include "perilymph/foundation/Version.h"
#include "perilymph/session/Csv.h"
#include "perilymph/validation/Prediction.h"

namespace perilymph::validation {

namespace {

using Json = nlohmann::ordered_json;

bool isWithin(Force force, const analysis::PrintedRange* range)
{
  return range && force.si() >= range->low && force.si() <= range->high;
}

Json json(const analysis::PrintedRange* range)
{
  if (!range) return nullptr;
  return {{"low_N", range->low}, {"high_N", range->high}, {"source", range->source}};
}

Json json(const ArraySummary& array, const analysis::PrintedRange* end,
          const analysis::PrintedRange* peak)
{
  Json page;
  page["array"] = array.array;
  if (array.mean)
    page["mean_cochlea"] = {{"apical_deg", inDegrees(array.mean->apical)},
                            {"end_N", array.mean->end.si()},
                            {"peak_N", array.mean->peak.si()}};
  page["patients"] = array.patients;
  page["complete"] = array.complete;
  if (array.patients > 0) {
    page["median_deg"] = inDegrees(array.median);
    page["lower_quartile_deg"] = inDegrees(array.lowerQuartile);
    page["upper_quartile_deg"] = inDegrees(array.upperQuartile);
    page["median_end_N"] = array.medianEnd.si();
    page["median_peak_N"] = array.medianPeak.si();
    page["end_within_in_vivo"] = isWithin(array.medianEnd, end);
    page["peak_within_in_vivo"] = isWithin(array.medianPeak, peak);
  }
  if (array.clinical) {
    page["clinical"] = {{"median_deg", inDegrees(array.clinical->median)},
                        {"low_deg", inDegrees(array.clinical->low)},
                        {"high_deg", inDegrees(array.clinical->high)},
                        {"source", array.clinical->source}};
    page["angle_within_clinical"] = array.hitsAngle;
  }
  return page;
}

}  // namespace

std::string predictionCsv(const PredictionResult& result)
{
  std::string csv = headerOf(predictionColumns()) + "\n";
  for (const PredictedInsertion& each : result.insertions) {
    csv += csvField(each.array) + "," + csvField(each.patient);
    for (const double value :
         {inDegrees(each.apical), inMillimeters(each.depth), each.end.si(), each.peak.si()})
      csv += "," + session::shortestDecimal(value);
    csv += "," + (each.error.empty() ? std::string() : csvQuoted(each.error)) + "\n";
  }
  return csv;
}

std::string predictionJson(const PredictionRequest& request, const PredictionResult& result,
                           const analysis::Reference& inVivo)
{
  const analysis::PrintedRange* end = inVivo.findRange("end of insertion");
  const analysis::PrintedRange* peak = inVivo.findRange("peak");
  Json page;
  page["version"] = version();
  page["scenario"] = request.scenario;
  page["seed"] = request.seed;
  page["patients"] = request.patients;
  page["in_vivo_end"] = json(end);
  page["in_vivo_peak"] = json(peak);
  page["arrays"] = Json::array();
  for (const ArraySummary& array : result.arrays) page["arrays"].push_back(json(array, end, peak));
  return page.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace perilymph::validation
