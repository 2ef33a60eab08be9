// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <nlohmann/json.hpp>

#include "perilymph/analysis/CsvField.h"
#include "perilymph/analysis/Surgeon.h"
#include "perilymph/foundation/Version.h"
#include "perilymph/session/Csv.h"
#include "perilymph/validation/ClinicalPrediction.h"

namespace perilymph::validation {

namespace {

using Json = nlohmann::ordered_json;

const char* nameOf(RowVerdict verdict)
{
  switch (verdict) {
    case RowVerdict::hit:
      return "hit";
    case RowVerdict::miss:
      return "miss";
    case RowVerdict::notJudged:
      break;
  }
  return "not judged";
}

Json json(const ClinicalRow& row)
{
  Json page;
  page["quantity"] = row.quantity;
  page["unit"] = row.unit;
  if (row.high > row.low) page["published"] = {{"low", row.low}, {"high", row.high}};
  page["source"] = row.source;
  page["confidence"] = row.confidence;
  page["runs"] = row.runs;
  page["median"] = row.median;
  page["lower_quartile"] = row.lowerQuartile;
  page["upper_quartile"] = row.upperQuartile;
  page["inside_fraction"] = row.inside;
  page["verdict"] = nameOf(row.verdict);
  page["is_clinical"] = row.isClinical;
  page["note"] = row.note;
  return page;
}

}  // namespace

std::string clinicalRowsCsv(const std::vector<ClinicalRow>& rows)
{
  std::string csv =
      "quantity,unit,published_low,published_high,median,lower_quartile,upper_quartile,"
      "inside_fraction,runs,verdict,is_clinical,confidence,source,note\n";
  for (const ClinicalRow& row : rows) {
    csv += analysis::csvQuoted(row.quantity) + "," + row.unit;
    for (const double value :
         {row.low, row.high, row.median, row.lowerQuartile, row.upperQuartile, row.inside})
      csv += "," + session::shortestDecimal(value);
    csv += "," + std::to_string(row.runs) + "," + nameOf(row.verdict) + "," +
           (row.isClinical ? "true" : "false") + "," + row.confidence + "," +
           analysis::csvQuoted(row.source) + "," + analysis::csvQuoted(row.note) + "\n";
  }
  return csv;
}

std::string clinicalInsertionsCsv(const std::vector<analysis::ClinicalInsertion>& insertions)
{
  std::string csv =
      "seed,patient,array,end,apical_deg,depth_mm,end_N,peak_N,partition_N,is_ruptured,reason,"
      "after_1s_N,after_10s_N\n";
  for (const analysis::ClinicalInsertion& each : insertions) {
    csv += std::to_string(each.seed) + "," + std::to_string(each.patient) + "," +
           analysis::csvField(each.array) + "," + haptics::nameOf(each.end);
    for (const double value : {inDegrees(each.apical), inMillimeters(each.depth),
                               each.endForce.si(), each.peak.si(), each.partition.si()})
      csv += "," + session::shortestDecimal(value);
    csv += std::string(",") + (each.isRuptured ? "true" : "false") + "," +
           (each.reason.empty() ? std::string() : analysis::csvQuoted(each.reason));
    for (const auto& force : {each.forceAfter1s, each.forceAfter10s})
      csv += "," + (force ? session::shortestDecimal(force->si()) : std::string());
    csv += '\n';
  }
  return csv;
}

Result<std::string> clinicalJson(const ClinicalRequest& request, const ClinicalResult& result)
{
  const auto hand = analysis::shippedHand();
  if (!hand) return hand.error();
  Json page;
  page["version"] = version();
  page["seeds"] = request.seeds;
  page["patients_per_seed"] = request.patients;
  page["friction"] = request.friction;
  page["rule"] =
      "hit: the median and at least half of the runs are within the published range; a rate: "
      "within "
      "the 95 % interval of the published count";
  page["hand"] = Json::array();
  for (const analysis::HandDistribution::Provenance& each : hand->provenance)
    page["hand"].push_back(
        {{"table", each.table}, {"source", each.source}, {"confidence", each.confidence}});
  page["ends"] = Json::object();
  using haptics::InsertionEnd;
  for (const InsertionEnd end :
       {InsertionEnd::finished, InsertionEnd::stoppedByResistance, InsertionEnd::buckled,
        InsertionEnd::outOfOpening, InsertionEnd::foldedTip, InsertionEnd::jammed,
        InsertionEnd::fault, InsertionEnd::refused})
    page["ends"][haptics::nameOf(end)] =
        std::count_if(result.insertions.begin(), result.insertions.end(),
                      [&](const analysis::ClinicalInsertion& each) { return each.end == end; });
  page["rows"] = Json::array();
  for (const ClinicalRow& row : result.rows) page["rows"].push_back(json(row));
  return page.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace perilymph::validation
