// SPDX-License-Identifier: BSD-3-Clause
#include "gui/report/PlanReportPdf.h"

#include <QCoreApplication>
#include <QDateTime>

#include "gui/report/CtPicture.h"
#include "gui/report/PlanAppendix.h"
#include "gui/report/PlanCurves.h"
#include "gui/report/PlanRecord.h"

namespace perilymph::gui {

namespace {

// lupdate assigns texts of free functions to their namespace.
QString tr(const char* text) { return QCoreApplication::translate("perilymph::gui", text); }

}  // namespace

Result<Done> writePlanReport(const PlanReportContent& content, const std::filesystem::path& file)
{
  ReportPages pages;
  pages.title = tr("Insertion plan");
  pages.subject = tr("Patient %1 · %2").arg(content.code(), content.ear());
  pages.time = localTimeOf(QDateTime::currentDateTimeUtc().toString(Qt::ISODate).toStdString());
  pages.paintRecord = [&content](ReportSheet& sheet, const ReportIssuer& issuer,
                                 const ReportArea& area) {
    paintPlanRecord(sheet, content, issuer, area);
  };
  if (content.plan().arrays.size() > maxDrawnArrays)
    pages.figures.push_back([&content](ReportSheet& sheet, const ReportArea& area) {
      paintAllPlanCurves(sheet, {0.0, area.top_mm, area.width_mm, area.bottom_mm - area.top_mm},
                         content);
    });
  pages.appendix = planAppendixText(content);
  pages.images = {{QStringLiteral("ct"), ctPictureOf(content.plan().request.patient)}};
  return writeReportPages(pages, file);
}

}  // namespace perilymph::gui
