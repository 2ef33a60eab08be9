// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Key images of the CT on pages of a report.

#include <string>

#include "gui/report/ReportPages.h"

namespace perilymph::gui {

/// Adds pages with the key images of a CT series, two on each; none where there are none.
///
/// @param seriesKey  SHA-256 of the series in which the patient was measured.
void addKeyImagePages(ReportPages& pages, const std::string& seriesKey);

}  // namespace perilymph::gui
