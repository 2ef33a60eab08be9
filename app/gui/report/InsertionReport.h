// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// PDF report of one insertion: a page for the record, and an appendix that makes it reproducible.

#include <QString>
#include <filesystem>

#include "gui/report/ReportContent.h"
#include "perilymph/foundation/Result.h"

class QWidget;

namespace perilymph::gui {

/// Asks for the file of a recording's report, beside the user's documents; empty if the user cancels.
QString askReportFile(const std::filesystem::path& recording, QWidget* parent);

/// Writes the report in A4, atomically. UI thread.
Result<Done> writeReport(const ReportContent& content, const std::filesystem::path& file);

}  // namespace perilymph::gui
