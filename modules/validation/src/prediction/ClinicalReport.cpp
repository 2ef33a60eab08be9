// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "ValidationColumns.h"
#include "perilymph/analysis/Surgeon.h"
#include "perilymph/foundation/CsvField.h"
#include "perilymph/foundation/Version.h"
#include "perilymph/session/Csv.h"
#include "perilymph/validation/ClinicalPrediction.h"

namespace perilymph::validation {

namespace {

using Json = nlohmann::ordered_json;

Json jsonNumber(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

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

Json json(const ClinicalCompanion& companion)
{
  return {{"found", jsonNumber(companion.found)},
          {"published", jsonNumber(companion.published)},
          {"runs", companion.runs},
          {"is_met", companion.isMet}};
}

Json json(const ClinicalRow& row)
{
  Json page;
  page["quantity"] = row.quantity;
  page["unit"] = row.unit;
  if (row.high > row.low)
    page["published"] = {{"low", row.low}, {"high", row.high}, {"median", row.published}};
  page["patients"] = row.patients;
  page["source"] = row.source;
  page["confidence"] = row.confidence;
  page["runs"] = row.runs;
  page["median"] = row.median;
  page["lower_quartile"] = row.lowerQuartile;
  page["upper_quartile"] = row.upperQuartile;
  page["inside_fraction"] = row.inside;
  page["verdict"] = nameOf(row.verdict);
  page["tolerance"] = row.tolerance;
  page["power"] = row.power;
  page["verdict_at_median_friction"] = nameOf(row.atMedianFriction);
  page["spread"] = {{"verdict", nameOf(row.spread)},
                    {"factor", row.spreadFactor},
                    {"tolerance", row.spreadTolerance}};
  if (row.contactsInside) page["contacts_inside"] = json(*row.contactsInside);
  if (row.angleAtLength) page["angle_at_published_length"] = json(*row.angleAtLength);
  if (row.depth_mm > 0.0) page["depth_mm"] = row.depth_mm;
  page["is_clinical"] = row.isClinical;
  page["note"] = row.note;
  return page;
}

/// Text of a number; empty for NaN.
std::string cell(double value)
{
  return std::isfinite(value) ? session::shortestDecimal(value) : std::string();
}

}  // namespace

std::string clinicalRowsCsv(const std::vector<ClinicalRow>& rows)
{
  std::string csv = headerOf(clinicalRowColumns()) + "\n";
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  const ClinicalCompanion nothing{none, none, 0, true};
  for (const ClinicalRow& row : rows) {
    csv += csvQuoted(row.quantity) + "," + row.unit;
    for (const double value :
         {row.low, row.high, row.median, row.lowerQuartile, row.upperQuartile, row.inside})
      csv += "," + session::shortestDecimal(value);
    csv += "," + std::to_string(row.runs) + "," + nameOf(row.verdict) + "," +
           (row.isClinical ? "true" : "false") + "," + row.confidence + "," +
           csvQuoted(row.source) + "," + csvQuoted(row.note) + "," + cell(row.published) + "," +
           std::to_string(row.patients) + "," + cell(row.tolerance) + "," + cell(row.power) + "," +
           nameOf(row.atMedianFriction) + "," + cell(row.spreadFactor) + "," +
           cell(row.spreadTolerance) + "," + nameOf(row.spread);
    const ClinicalCompanion inside = row.contactsInside.value_or(nothing);
    const ClinicalCompanion angle = row.angleAtLength.value_or(nothing);
    csv += "," + cell(inside.found) + "," + cell(inside.published) + "," + cell(angle.found) + "," +
           std::to_string(angle.runs) + "," + cell(angle.published) + "," + cell(row.depth_mm) +
           "\n";
  }
  return csv;
}

std::string clinicalInsertionsCsv(const std::vector<analysis::ClinicalInsertion>& insertions)
{
  std::string csv = headerOf(clinicalInsertionColumns()) + "\n";
  for (const analysis::ClinicalInsertion& each : insertions) {
    csv += std::to_string(each.seed) + "," + std::to_string(each.patient) + "," +
           csvField(each.array) + "," + haptics::nameOf(each.end);
    for (const double value : {inDegrees(each.apical), inMillimeters(each.depth),
                               each.endForce.si(), each.peak.si(), each.partition.si()})
      csv += "," + session::shortestDecimal(value);
    csv += std::string(",") + (each.isRuptured ? "true" : "false") + "," +
           (each.reason.empty() ? std::string() : csvQuoted(each.reason));
    for (const auto& force : {each.forceAfter1s, each.forceAfter10s})
      csv += "," + (force ? session::shortestDecimal(force->si()) : std::string());
    const auto inside =
        std::count_if(each.contacts.begin(), each.contacts.end(),
                      [](const analysis::ContactPosition& contact) { return contact.isInserted; });
    csv += "," + session::shortestDecimal(each.sharedFriction) + "," + std::to_string(inside) +
           "," + std::to_string(each.contacts.size()) + "," +
           (each.isTranslocated ? "true" : "false") + '\n';
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
      "angle: hit if the medians differ by at most 1.96 standard errors, of both samples, the "
      "uncertain friction and the differences between centers; rate: hit if the published count is "
      "within 95 % of those expected after the simulated one";
  page["perfect_model"] = {{"rows", result.perfect.rows},
                           {"expected_hits", result.perfect.expected},
                           {"probability_of_all", result.perfect.all},
                           {"probability_of_hits", result.perfect.exactly}};
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
