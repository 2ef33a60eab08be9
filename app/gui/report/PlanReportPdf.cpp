// SPDX-License-Identifier: BSD-3-Clause
#include "gui/report/PlanReportPdf.h"

#include <QCoreApplication>

#include "gui/report/CtPicture.h"
#include "gui/report/KeyImagePages.h"
#include "gui/report/PlanAppendix.h"
#include "gui/report/PlanCurves.h"
#include "gui/report/PlanInfluences.h"
#include "gui/report/PlanRecord.h"
#include "perilymph/foundation/UtcTime.h"

namespace perilymph::gui {

namespace {

// lupdate assigns texts of free functions to their namespace.
QString tr(const char* text) { return QCoreApplication::translate("perilymph::gui", text); }

}  // namespace

Result<void> writePlanReport(const PlanReportContent& content, const std::filesystem::path& file)
{
  ReportPages pages;
  pages.title = tr("Insertion plan");
  pages.subject = tr("Patient %1 · %2").arg(content.code(), content.ear());
  pages.time = localTimeOf(utcNow());
  References references;
  pages.paintRecord = [&](ReportSheet& sheet, const ReportIssuer& issuer, const ReportArea& area) {
    paintPlanRecord(sheet, content, issuer, references, area);
  };
  constexpr std::size_t fewArrays = 3;  // have their curves on the record
  if (content.plan().arrays.size() > fewArrays)
    pages.figures.push_back([&content](ReportSheet& sheet, const ReportArea& area) {
      paintAllPlanCurves(sheet, {0.0, area.top_mm, area.width_mm, area.bottom_mm - area.top_mm},
                         content);
    });
  for (std::size_t page = 0; page < influencePages(content); ++page)
    pages.figures.push_back([&content, page](ReportSheet& sheet, const ReportArea& area) {
      paintPlanInfluences(sheet, content, page, area);
    });
  addKeyImagePages(pages, content.identity().seriesKey);
  pages.appendix = [&] { return planAppendixText(content, references); };
  pages.images = {{QStringLiteral("ct"), ctPictureOf(content.plan().request.patient)}};
  return writeReportPages(pages, file);
}

}  // namespace perilymph::gui
