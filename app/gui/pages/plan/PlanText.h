// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Texts of a plan: columns of its table, bands and probabilities with their units.

#include <QString>
#include <optional>
#include <vector>

#include "perilymph/analysis/ClinicalReports.h"
#include "perilymph/planning/PlanSummary.h"

namespace perilymph::gui {

/// Columns of a plan's table.
enum class PlanColumn {
  array,
  angle,
  coverage,
  peak,
  end,
  force,
  partition,
  complete,
  resisted,
  buckled,
  foldedTip,
  ruptured
};
inline constexpr int planColumns = 12;

/// What a column's cells show.
enum class PlanCellKind { name, band, curve, probability };
PlanCellKind kindOf(PlanColumn column);

/// "Angular insertion depth"
QString titleOf(PlanColumn column);
/// How the values are obtained, and from which sources.
QString methodOf(PlanColumn column);

/// The band of a column of bands.
const planning::Band& bandOf(const planning::ArrayPlan& plan, PlanColumn column);
/// The estimate of a column of probabilities.
const analysis::Estimate& estimateOf(const planning::ArrayPlan& plan, PlanColumn column);

/// "421 (380–455)°": median, and 5 to 95 %.
QString bandText(const planning::Band& band, PlanColumn column);
/// "421°" and "380–455°".
QString medianText(const planning::Band& band, PlanColumn column);
QString rangeText(const planning::Band& band, PlanColumn column);
/// What clinics report beside the values of a column; nothing for other columns.
std::optional<analysis::ReportedQuantity> reportedOf(PlanColumn column);
/// "85–98 %": the 95 % interval of a share of simulations that is given in percent, else nothing.
QString intervalText(const analysis::Estimate& estimate, std::size_t draws);
/// Sentences on an array of a plan: bands at the median friction, first resistance, strength of the
/// partition, forces at rest.
QString factsOf(const planning::ArrayPlan& array, const planning::Plan& plan);
/// A line for every two of some arrays of a plan, with what they differ by in the same ear; empty
/// where the plan has no differences.
QString differencesOf(const planning::Plan& plan, const std::vector<std::size_t>& arrays);
/// "FLEX28 · draw 13: 421°, peak 80 mN"
QString shapeTitle(const planning::ArrayPlan& array, const planning::PlannedInsertion& insertion);
/// "8.94 to 9.52 mm" around a length with a normal error: 95 %.
QString measureText(Length value, Length standardDeviation);

}  // namespace perilymph::gui
