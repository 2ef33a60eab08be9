// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// PDF report of a plan: a page for the record, and an appendix with contacts and sources.

#include <filesystem>

#include "gui/report/PlanReportContent.h"
#include "perilymph/foundation/Result.h"

namespace perilymph::gui {

/// Writes the report in A4, atomically. It states the numbers of plan.json. UI thread.
Result<void> writePlanReport(const PlanReportContent& content, const std::filesystem::path& file);

}  // namespace perilymph::gui
