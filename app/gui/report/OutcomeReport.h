// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// PDF report of an outcome: one page with what was found, the plan beside it, and what is doubtful.

#include <QImage>
#include <filesystem>
#include <memory>
#include <string>

#include "gui/report/ReportFile.h"
#include "perilymph/figures/Drawing.h"
#include "perilymph/foundation/Result.h"
#include "perilymph/outcome/ClinicOutcomes.h"
#include "perilymph/outcome/OutcomeText.h"
#include "perilymph/planning/PlanReading.h"

namespace perilymph::gui {

struct OutcomeReportContent {
  anatomy::Patient patient;
  outcome::OutcomeContent content;
  std::shared_ptr<const planning::StoredPlan> plan;  ///< Null without one.
  std::size_t place = 0;                             ///< Place of the array in the plan.
  std::string planMadeUtc;
  outcome::PlannedOutcome ends;  ///< The plan's simulations as they ended; it may be empty.
  QString planDoubt;             ///< Why the plan is no prediction, a sentence; empty if it is one.
  QImage view;  ///< The cochlear view with the contacts; null where the CT is not there.
  figures::Drawing unrolled;  ///< The unrolled scala; it may be empty.

  const planning::ArrayPlan* arrayPlan() const
  {
    return plan ? &plan->plan.arrays[place] : nullptr;
  }
  /// Its series is that of the CT after surgery.
  ReportIdentity identity() const;
};

/// Writes the report in A4, atomically. UI thread.
Result<void> writeOutcomeReport(const OutcomeReportContent& content,
                                const std::filesystem::path& file);

}  // namespace perilymph::gui
