// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Sending a report to a DICOM archive: one way for plans and insertions.

#include <QString>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "gui/report/ReportFile.h"

class QWidget;

namespace perilymph::gui {

/// The folder of the CT series with this SHA-256, if it is open in the window.
using CtPlaces = std::function<std::optional<std::filesystem::path>(const std::string& seriesKey)>;

/// The PDF of a report for an archive. Refuses a report that states no CT series to compare with. UI thread.
Result<std::string> pdfToSend(const PdfWriting& writing, const ReportIdentity& identity);

/// Opens the dialog that sends a report into the study of its CT.
///
/// @param name  "Report of the plan (PDF)"
void sendReport(const QString& name, const std::string& pdf, const ReportIdentity& identity,
                const CtPlaces& places, QWidget* parent);

}  // namespace perilymph::gui
