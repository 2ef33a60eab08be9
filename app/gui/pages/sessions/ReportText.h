#pragma once

// What a report says, in its order.

#include <QString>

#include "gui/pages/sessions/ReportContent.h"

namespace perilymph::gui {

/// The report's text as HTML, every name in it escaped; its pictures are called "curve" and
/// "picture".
QString reportText(const ReportContent& content);

}  // namespace perilymph::gui
