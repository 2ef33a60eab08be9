// SPDX-License-Identifier: BSD-3-Clause
#include "ClinicalJson.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "PlanNumbers.h"
#include "perilymph/analysis/ClinicalReports.h"

namespace perilymph::planning {

nlohmann::ordered_json clinicalJson(const std::string& array)
{
  const auto& evidence = analysis::ClinicalEvidence::shipped();
  if (!evidence) return {{"error", evidence.error().message}};
  nlohmann::ordered_json json = {{"clinical_table", analysis::nameOf(evidence->verdictOf(array))},
                                 {"missed_rows", evidence->missedRows(array)},
                                 {"reports", nlohmann::ordered_json::array()}};
  for (const analysis::ClinicalReport& each : evidence->reports()) {
    if (std::ranges::find(each.arrays, array) == each.arrays.end()) continue;
    nlohmann::ordered_json report = {{"quantity", analysis::nameOf(each.quantity)},
                                     {"statistic", each.statistic}};
    if (each.value) report["value"] = rounded(*each.value);
    if (each.spread != analysis::ReportedSpread::none) {
      report["spread"] = analysis::nameOf(each.spread);
      report["low"] = rounded(each.low);
      report["high"] = rounded(each.high);
    }
    if (each.count) report["count"] = *each.count;
    if (each.n > 0) report["n"] = each.n;
    if (!each.nOf.empty()) report["n_of"] = each.nOf;
    if (!each.valueOf.empty()) report["value_of"] = each.valueOf;
    report["definition"] = each.definition;
    report["source"] = each.source;
    report["read"] = each.read;
    report["confidence"] = each.confidence;
    json["reports"].push_back(std::move(report));
  }
  return json;
}

}  // namespace perilymph::planning
