// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The report of a plan from the command line, without a window and without a display.

#include "gui/program/CommandLine.h"
#include "gui/report/PlanReportContent.h"
#include "perilymph/foundation/Result.h"

namespace perilymph::gui {

/// Content of the report that --plan and --report request. Needs no QApplication, so that Qt has
/// not written anything to standard error when the plan is refused.
Result<PlanReportContent> reportedPlan(const CommandLine& options);

/// Writes the report as PDF, or as a DICOM object that holds it. Call after QApplication.
Result<void> writeReport(const PlanReportContent& content, const CommandLine& options);

/// Makes Qt draw without a display. Call before QApplication.
void drawWithoutDisplay();

}  // namespace perilymph::gui
