// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Whose a report is: the line on top of every page.

#include <QString>

#include "gui/report/ReportContent.h"

namespace perilymph::gui {

/// "Patient P-017 · left ear", or the anatomy if there is no patient.
QString subjectOf(const ReportContent& content);

}  // namespace perilymph::gui
