// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The first page of a report, for the patient's record.

#include "gui/report/References.h"
#include "gui/report/ReportContent.h"
#include "gui/report/ReportPages.h"

namespace perilymph::gui {

/// Paints the record, with the signature at its lower end.
void paintRecord(ReportSheet& sheet, const ReportContent& content, const ReportIssuer& issuer,
                 References& references, const ReportArea& area);

}  // namespace perilymph::gui
