// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// PDF report of one insertion: a page for the record, and an appendix that makes it reproducible.

#include <filesystem>
#include <optional>

#include "gui/report/ReportContent.h"
#include "gui/report/ReportSaving.h"
#include "perilymph/foundation/Result.h"

class QWidget;

namespace perilymph::gui {

/// Asks where to save a recording's report; empty if the user cancels.
std::optional<ReportPlace> askReportPlace(const std::filesystem::path& recording, QWidget* parent);

/// "Report of the insertion (PDF)", where it is sent.
QString insertionReportName();

/// Writes the report in A4, atomically. UI thread.
Result<void> writeReport(const ReportContent& content, const std::filesystem::path& file);

}  // namespace perilymph::gui
