// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Text of a report's appendix: everything needed to reproduce it.

#include <QString>

#include "gui/report/References.h"
#include "gui/report/ReportContent.h"

namespace perilymph::gui {

/// The appendix of a report as HTML, with all names escaped.
///
/// @param references  Those of the record; they are listed at the end.
QString appendixText(const ReportContent& content, References& references);

}  // namespace perilymph::gui
