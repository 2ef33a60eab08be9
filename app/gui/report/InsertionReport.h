// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// PDF report of one insertion: a page for the record, and an appendix that makes it reproducible.

#include <filesystem>

#include "gui/report/ReportContent.h"
#include "perilymph/foundation/Result.h"

namespace perilymph::gui {

/// Writes the report in A4, atomically. UI thread.
Result<Done> writeReport(const ReportContent& content, const std::filesystem::path& file);

}  // namespace perilymph::gui
