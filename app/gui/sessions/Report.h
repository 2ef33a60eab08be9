#pragma once

// A report of one insertion as PDF: numbers with where they come from, curve, picture, limits.

#include <QString>
#include <filesystem>

#include "ReportContent.h"
#include "perilymph/foundation/Result.h"

namespace perilymph::gui {

/// The report's words as HTML; its pictures are called "curve" and "picture".
QString reportText(const ReportContent& content);

/// Writes the report, A4; the file appears whole or not at all. UI thread.
Result<Done> writeReport(const ReportContent& content, const std::filesystem::path& file);

}  // namespace perilymph::gui
