// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The first page of a plan's report. In this order: identification, cochlea, arrays, drawings,
// method and limits, signature.

#include "gui/report/PlanReportContent.h"
#include "gui/report/References.h"
#include "gui/report/ReportPages.h"

namespace perilymph::gui {

/// Paints the page for the record.
void paintPlanRecord(ReportSheet& sheet, const PlanReportContent& content,
                     const ReportIssuer& issuer, References& references, const ReportArea& area);

}  // namespace perilymph::gui
