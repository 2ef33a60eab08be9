// SPDX-License-Identifier: BSD-3-Clause
#include <string>

#include "PlanColumns.h"
#include "PlanNumbers.h"
#include "perilymph/analysis/ClinicalReports.h"
#include "perilymph/foundation/CsvField.h"
#include "perilymph/planning/PlanReport.h"
#include "perilymph/planning/PlanWords.h"
#include "perilymph/session/Csv.h"

namespace perilymph::planning {

namespace {

std::string number(double value) { return session::shortestDecimal(rounded(value)); }

std::string cellsOf(const Band& band)
{
  std::string cells;
  for (const double value :
       {band.low, band.lowerQuartile, band.median, band.upperQuartile, band.high})
    cells += "," + number(value);
  return cells;
}

std::string cellsOf(const analysis::Estimate& estimate)
{
  std::string cells;
  for (const double value : {estimate.value, estimate.low, estimate.high})
    cells += "," + number(100.0 * value);
  return cells;
}

/// The first report of each quantity; empty fields where there is none.
std::string cellsOfReports(const std::string& array)
{
  const auto& evidence = analysis::ClinicalEvidence::shipped();
  std::string cells;
  for (const analysis::ReportedQuantity quantity : besideArrays) {
    const analysis::ClinicalReport* report = evidence ? evidence->find(array, quantity) : nullptr;
    if (report == nullptr) {
      cells += ",,,,,,";
      continue;
    }
    const bool hasBounds = report->spread != analysis::ReportedSpread::none;
    cells += "," + (report->value ? number(*report->value) : std::string());
    cells += hasBounds ? "," + number(report->low) + "," + number(report->high) : ",,";
    cells += "," + (hasBounds ? std::string(analysis::nameOf(report->spread)) : std::string());
    cells += "," + (report->n > 0 ? std::to_string(report->n) : std::string());
    cells += "," + csvField(report->valueOf.empty() ? report->nOf : report->valueOf);
  }
  return cells + "," + (evidence ? analysis::nameOf(evidence->verdictOf(array)) : "");
}

}  // namespace

std::string arraysCsv(const Plan& plan)
{
  std::string csv = headerOf(planArrayColumns()) + "\n";
  for (const ArrayPlan& each : plan.arrays) {
    csv += csvField(each.array) + "," + csvField(each.name) + "," + std::to_string(each.draws);
    for (const PlanQuantity& quantity : planQuantities()) csv += cellsOf(each.*quantity.band);
    for (const PlanProbability& chance : planProbabilities()) csv += cellsOf(each.*chance.estimate);
    csv += "," + csvField(bandsHold(plan));
    for (const FrictionQuantity& quantity : frictionQuantities)
      csv += each.atMedianFriction ? cellsOf(*each.atMedianFriction.*quantity.band) : ",,,,,";
    csv += cellsOfReports(each.array) + "\n";
  }
  return csv;
}

std::string differencesCsv(const Plan& plan)
{
  std::string csv = headerOf(planDifferenceColumns()) + "\n";
  for (const ArrayDifference& each : plan.differences) {
    csv += csvField(plan.arrays[each.first].array) + "," +
           csvField(plan.arrays[each.second].array) + "," + std::to_string(each.draws);
    for (const DifferenceQuantity& quantity : differenceQuantities)
      csv += cellsOf(each.*quantity.band);
    for (const DifferenceProbability& chance : differenceProbabilities)
      csv += cellsOf(each.*chance.estimate);
    csv += '\n';
  }
  return csv;
}

}  // namespace perilymph::planning
