// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Picture of the report: the array at its maximum depth, with angle ring, scale bar, ear, and the
// numbers of its contacts.

#include "gui/report/ReportContent.h"
#include "gui/report/ReportSheet.h"

namespace perilymph::gui {

/// Paints it into a rectangle [mm], to scale.
void paintReportPicture(ReportSheet& sheet, const QRectF& place_mm, const ReportContent& content);

}  // namespace perilymph::gui
