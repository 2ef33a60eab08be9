// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Text of a report's appendix: everything needed to reproduce it.

#include <QString>

#include "gui/report/ReportContent.h"

namespace perilymph::gui {

/// The appendix of a report as HTML, with all names escaped; its chart is called "curve".
QString appendixText(const ReportContent& content);

}  // namespace perilymph::gui
