// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// What decides angle and peak force of a plan's arrays: tornado charts.

#include "gui/report/PlanReportContent.h"
#include "gui/report/ReportPages.h"

namespace perilymph::gui {

/// Number of pages that the charts of a plan take; none if no influence is known.
std::size_t influencePages(const PlanReportContent& content);

/// Paints a page of charts, one for each array: the inputs from the strongest on, bars to the left for
/// the share of the angle's variance, to the right for that of the peak force.
///
/// @param page  From 0.
void paintPlanInfluences(ReportSheet& sheet, const PlanReportContent& content, std::size_t page,
                         const ReportArea& area);

}  // namespace perilymph::gui
