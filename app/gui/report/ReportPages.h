// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The pages of a PDF report: a painted page for the record, painted figures, and an appendix as
// flowing text.

#include <QImage>
#include <QString>
#include <filesystem>
#include <functional>
#include <utility>
#include <vector>

#include "gui/report/ReportIssuer.h"
#include "gui/report/ReportSheet.h"
#include "perilymph/foundation/Result.h"

namespace perilymph::gui {

/// Where the content of a page is [mm].
struct ReportArea {
  double top_mm = 0.0, bottom_mm = 0.0, width_mm = 0.0;
};

/// A name and a value of a report; an empty value leaves a line to write on.
struct ReportEntry {
  QString name, value;
};

struct ReportPages {
  QString title;    ///< Title of the file.
  QString subject;  ///< On top of every page: "Patient P-017 · left ear".
  QString time;     ///< At the foot of every page.
  std::function<void(ReportSheet&, const ReportIssuer&, const ReportArea&)> paintRecord;
  /// Painted pages between the record and the appendix's text.
  std::vector<std::function<void(ReportSheet&, const ReportArea&)>> figures;
  /// HTML with all names escaped; asked for after the record was painted. Without one there is no appendix.
  std::function<QString()> appendix;
  std::vector<std::pair<QString, QImage>> images;  ///< Those of the appendix, by name.
};

/// Writes a report in A4, atomically, with institution and logo of the settings. UI thread.
Result<void> writeReportPages(const ReportPages& pages, const std::filesystem::path& file);

/// Paints the title of a report with what it must not be used for.
///
/// @return  Where the content begins [mm].
double paintReportTitle(ReportSheet& sheet, const QString& title, const ReportArea& area);

/// Paints entries, one below the other.
///
/// @return  Their lower end [mm].
double paintEntries(ReportSheet& sheet, const std::vector<ReportEntry>& entries, double x_mm,
                    double y_mm, double width_mm);

/// Paints the lines for date, name and signature at the lower end of a page, at least 10 mm below
/// `y_mm`.
void paintSignature(ReportSheet& sheet, double y_mm, const ReportArea& area);

}  // namespace perilymph::gui
