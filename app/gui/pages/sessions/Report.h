#pragma once

// A report of one insertion as PDF: numbers with where they come from, curve, picture, limits.

#include <filesystem>

#include "gui/pages/sessions/ReportContent.h"
#include "perilymph/foundation/Result.h"

namespace perilymph::gui {

/// Writes the report, A4; the file appears whole or not at all. UI thread.
Result<Done> writeReport(const ReportContent& content, const std::filesystem::path& file);

}  // namespace perilymph::gui
