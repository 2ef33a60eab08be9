// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Content of the report of a plan: the plan as stored, and the cochlea it is for.

#include <QColor>
#include <QString>
#include <filesystem>
#include <memory>
#include <vector>

#include "gui/report/ReportFile.h"
#include "perilymph/analysis/AnatomyMeasures.h"
#include "perilymph/anatomy/ScalaTympani.h"
#include "perilymph/figures/FixedInks.h"
#include "perilymph/foundation/Result.h"
#include "perilymph/planning/PlanReading.h"

namespace perilymph::gui {

struct PlanReportContent {
  planning::StoredPlan stored;
  std::shared_ptr<const anatomy::ScalaTympani>
      anatomy;  ///< Built from the measures without errors.
  std::vector<analysis::Measure> measures;
  std::vector<double> bands;  ///< Their uncertainty, or empty.
  /// Whether the report becomes part of a study that could not be compared with the plan's series.
  bool isStudyNotCompared = false;

  const planning::Plan& plan() const { return stored.plan; }
  /// The patient's code; "–" if the label is not a code: it may be a name, which no report states.
  QString code() const;
  QString ear() const;
  /// The plan's number; that it was changed by hand, which leaves it none.
  QString number() const;
  /// Its series is that in which the patient was measured; none where no seal vouches for it.
  ReportIdentity identity() const;
};

/// Number of arrays whose curves and depths are drawn on the record, the first ones of the plan.
inline constexpr std::size_t maxDrawnArrays = figures::ink::arrays.size();

/// Color of an array in the drawings, by its place in the plan.
QColor inkOfArray(std::size_t place);

/// "3  Nucleus Slim Straight": an array's place in the plan and its name without the models.
QString numberedName(const planning::ArrayPlan& array, std::size_t place);

/// Median and band in brackets: "523 (490–560)".
QString medianText(const planning::Band& band, int decimals);

/// A share of an array's simulations below a head that states the unit: "3 of 16"; from
/// analysis::fewestForPercent on, percent with the interval: "3 (0–8)".
QString chanceText(const analysis::Estimate& estimate, std::size_t draws);

/// Builds the cochlea of a plan, in about a second. Any thread.
Result<PlanReportContent> planReportContent(planning::StoredPlan stored);

}  // namespace perilymph::gui
