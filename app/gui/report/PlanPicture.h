// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The arrays of a plan in the cochlear view.

#include "gui/report/PlanReportContent.h"
#include "gui/report/ReportSheet.h"

namespace perilymph::gui {

/// Paints the first arrays, each in a picture of its own: a line to the median of the most apical
/// contact's angle, a broad one from 5 to 95 % of the draws, the contacts at their medians, at the
/// median distances of the contacts from the inner wall.
void paintPlanPicture(ReportSheet& sheet, const QRectF& place_mm, const PlanReportContent& content);

}  // namespace perilymph::gui
