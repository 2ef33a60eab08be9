// SPDX-License-Identifier: BSD-3-Clause
#include "gui/report/InsertionReport.h"

#include <QCoreApplication>

#include "gui/report/CtPicture.h"
#include "gui/report/KeyImagePages.h"
#include "gui/report/ReportHeader.h"
#include "gui/report/ReportPages.h"
#include "gui/report/ReportRecord.h"
#include "gui/report/ReportText.h"
#include "perilymph/session/SessionLibrary.h"

namespace perilymph::gui {

namespace {

// lupdate assigns texts of free functions to their namespace.
QString tr(const char* text) { return QCoreApplication::translate("perilymph::gui", text); }

}  // namespace

std::optional<ReportPlace> askReportPlace(const std::filesystem::path& recording, QWidget* parent)
{
  const std::string ear = session::summarize(recording).side;
  return askReportPlace(
      tr("Report of the insertion"),
      QString::fromStdString(recording.stem().string() + (ear.empty() ? "" : "-" + ear)), parent);
}

QString insertionReportName() { return tr("Report of the insertion (PDF)"); }

Result<void> writeReport(const ReportContent& content, const std::filesystem::path& file)
{
  ReportPages pages;
  pages.title = tr("Insertion report");
  pages.subject = subjectOf(content);
  pages.time = localTimeOf(content.facts.startedUtc);
  References references;
  pages.paintRecord = [&](ReportSheet& sheet, const ReportIssuer& issuer, const ReportArea& area) {
    paintRecord(sheet, content, issuer, references, area);
  };
  addKeyImagePages(pages, content.identity().seriesKey);
  pages.appendix = [&] { return appendixText(content, references); };
  pages.images = {{QStringLiteral("ct"), ctPictureOf(content.patient())}};
  return writeReportPages(pages, file);
}

}  // namespace perilymph::gui
