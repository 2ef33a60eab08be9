// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Force over depth of a plan's arrays: small charts with common axes.

#include "gui/report/PlanReportContent.h"
#include "gui/report/ReportSheet.h"

namespace perilymph::gui {

/// Paints the insertion force over depth of the first arrays on common axes: median, and bands of 25
/// to 75 and of 5 to 95 % of the draws.
void paintPlanCurves(ReportSheet& sheet, const QRectF& place_mm, const PlanReportContent& content);

/// Paints the charts of all arrays as small multiples in a place [mm], a page's.
void paintAllPlanCurves(ReportSheet& sheet, const QRectF& place_mm,
                        const PlanReportContent& content);

}  // namespace perilymph::gui
