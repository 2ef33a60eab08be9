// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Text of a report.

#include <QString>

#include "gui/pages/sessions/ReportContent.h"

namespace perilymph::gui {

/// The report's text as HTML, with all names escaped; its pictures are called "curve" and
/// "picture".
QString reportText(const ReportContent& content);

}  // namespace perilymph::gui
