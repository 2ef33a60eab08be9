// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The first page of a report, for the patient's record.

#include "gui/pages/sessions/ReportContent.h"
#include "gui/pages/sessions/ReportHead.h"
#include "gui/pages/sessions/ReportSheet.h"

namespace perilymph::gui {

/// Paints the record below a header.
///
/// @param top_mm    Where it begins.
/// @param bottom_mm Where it ends: the signature is there.
/// @param width_mm  Of the page's text.
void paintRecord(ReportSheet& sheet, const ReportContent& content, const ReportIssuer& issuer,
                 double top_mm, double bottom_mm, double width_mm);

}  // namespace perilymph::gui
