// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Force over depth of one insertion, with what its plan expects and the thresholds of the window.

#include "gui/report/ReportContent.h"
#include "gui/report/ReportSheet.h"

namespace perilymph::gui {

/// Paints the insertion force over the depth of the tip, the plan's median and band where there is a
/// plan, the force that surgeons feel and the range of peak forces in patients.
void paintInsertionCurve(ReportSheet& sheet, const QRectF& place_mm, const ReportContent& content);

}  // namespace perilymph::gui
