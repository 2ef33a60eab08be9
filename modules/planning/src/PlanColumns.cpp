// SPDX-License-Identifier: BSD-3-Clause
#include "PlanColumns.h"

#include <algorithm>
#include <string>
#include <utility>

#include "perilymph/planning/PlanReport.h"
#include "perilymph/planning/PlannedShape.h"

namespace perilymph::planning {

namespace {

/// What the quantities and probabilities of a plan are, by their keys.
const FieldMeaning& meaningOf(const std::string& key)
{
  static const FieldMeanings meanings = {
      {"angle_deg", "deg", "angular insertion depth"},
      {"coverage_percent", "%",
       "cochlear coverage: organ of Corti basal to the most apical contact"},
      {"depth_mm", "mm", "insertion depth at the end"},
      {"peak_mN", "mN", "peak insertion force"},
      {"end_mN", "mN", "axial force where the hand stops"},
      {"partition_mN", "mN", "largest force on the cochlear partition within one contact"},
      {"first_resistance_mm", "mm",
       "insertion depth at which the force first reaches the median that surgeons detect"},
      {"force_after_1s_mN", "mN", "axial force after 1 s of rest"},
      {"force_after_10s_mN", "mN", "axial force after 10 s of rest"},
      {"intended_depth_reached", "%", "the intended depth is reached"},
      {"stopped_by_resistance", "%", "the force reaches the limit at which the surgeon stops"},
      {"buckled", "%", "the array buckles in front of the opening"},
      {"folded_tip", "%", "the tip points back along the scala"},
      {"other_end", "%", "it ends otherwise: out of the opening, jammed, refused"},
      {"partition_ruptured", "%", "the cochlear partition ruptures"},
      {"translocated", "%", "a part of the array is in the scala vestibuli at the end"},
      {"partition_reaches_weakest", "%",
       "the partition force reaches the smallest reported strength"},
      {"partition_reaches_strongest", "%",
       "the partition force reaches the largest reported strength"},
      {"resistance_felt", "%", "the force reaches the median that surgeons detect"},
      {"all_contacts_inside", "%", "every contact is past the opening"},
      {"first_is_deeper", "%", "the first array reaches the larger angle"},
      {"first_has_higher_peak", "%", "the first array has the higher peak insertion force"}};
  const auto found = std::ranges::find(meanings, key, &FieldMeaning::name);
  static const FieldMeaning unknown;
  return found == meanings.end() ? unknown : *found;
}

void addBand(FieldMeanings& columns, const std::string& prefix, const std::string& key,
             const std::string& before)
{
  const FieldMeaning& meaning = meaningOf(key);
  for (const auto& [name, words] :
       {std::pair("p5", "5 % quantile"), std::pair("p25", "lower quartile"),
        std::pair("median", "median"), std::pair("p75", "upper quartile"),
        std::pair("p95", "95 % quantile")})
    columns.push_back(
        {prefix + key + "_" + name, meaning.unit, before + meaning.meaning + ", " + words});
}

void addProbability(FieldMeanings& columns, const std::string& key)
{
  const FieldMeaning& meaning = meaningOf(key);
  columns.push_back({key + "_percent", meaning.unit, "simulations in which " + meaning.meaning});
  columns.push_back({key + "_low", meaning.unit, "lower limit of its 95 % interval"});
  columns.push_back({key + "_high", meaning.unit, "upper limit"});
}

FieldMeanings arrayColumns()
{
  FieldMeanings columns = {{"array", "", "file name of the array"},
                           {"name", "", "name of the array"},
                           {"draws", "", "number of simulations"}};
  for (const PlanQuantity& each : planQuantities()) addBand(columns, "", each.key, "");
  for (const PlanProbability& each : planProbabilities()) addProbability(columns, each.key);
  columns.push_back({"bands_hold", "", "what the quantiles from 5 to 95 % hold"});
  for (const FrictionQuantity& each : frictionQuantities)
    addBand(columns, "at_median_friction_", each.key, "at the median friction: ");
  for (const analysis::ReportedQuantity quantity : besideArrays) {
    const std::string name = std::string("reported_") + analysis::nameOf(quantity);
    const bool isForce = quantity == analysis::ReportedQuantity::peakForce ||
                         quantity == analysis::ReportedQuantity::endForce;
    const char* const unit = isForce                                         ? "mN"
                             : quantity == analysis::ReportedQuantity::angle ? "deg"
                                                                             : "%";
    columns.push_back({name, unit, "what clinics report of this array; empty without a report"});
    columns.push_back({name + "_low", unit, "lower limit of its spread"});
    columns.push_back({name + "_high", unit, "upper limit"});
    columns.push_back(
        {name + "_spread", "", "what the limits are: quartiles, range, sd or interval95"});
    columns.push_back({name + "_n", "", "number of ears of the report"});
    columns.push_back(
        {name + "_of", "", "whose value or number it is, where that is not the array's alone"});
  }
  columns.push_back(
      {"clinical_table", "", "whether the array is a hit or a miss in the clinical table"});
  return columns;
}

FieldMeanings differenceColumns()
{
  FieldMeanings columns = {{"first", "", "file name of the first array"},
                           {"second", "", "file name of the second array"},
                           {"draws", "", "number of simulations that both have"}};
  for (const DifferenceQuantity& each : differenceQuantities)
    addBand(columns, "", each.key, "first less second in the same simulation: ");
  for (const DifferenceProbability& each : differenceProbabilities)
    addProbability(columns, each.key);
  return columns;
}

}  // namespace

const FieldMeanings& planArrayColumns()
{
  static const FieldMeanings columns = arrayColumns();
  return columns;
}

const FieldMeanings& shapeColumns()
{
  static const FieldMeanings columns = {{"array", "", "file name of the array"},
                                        {"draw", "", "number of its median simulation"},
                                        {"node", "", "node of the array, 1 at the base"},
                                        {"x_mm", "mm", "position in the cochlear frame, x"},
                                        {"y_mm", "mm", "the same, y"},
                                        {"z_mm", "mm", "the same, z"}};
  return columns;
}

const FieldMeanings& planDifferenceColumns()
{
  static const FieldMeanings columns = differenceColumns();
  return columns;
}

}  // namespace perilymph::planning
