// SPDX-License-Identifier: BSD-3-Clause
#include "gui/report/InsertionReport.h"

#include <QCoreApplication>
#include <QFileDialog>
#include <QPainter>
#include <algorithm>

#include "gui/report/CtPicture.h"
#include "gui/report/ReportHead.h"
#include "gui/report/ReportPages.h"
#include "gui/report/ReportRecord.h"
#include "gui/report/ReportText.h"
#include "gui/widgets/DrawingPainter.h"
#include "gui/widgets/StatusLine.h"
#include "perilymph/figures/Figure.h"

namespace perilymph::gui {

using figures::Figure;  // unqualified below, as lupdate needs it

namespace {

// lupdate assigns texts of free functions to their namespace.
QString tr(const char* text) { return QCoreApplication::translate("perilymph::gui", text); }

/// Insertion force in mN over travel.
Figure figureOf(const ReportContent& content)
{
  figures::FigureCurve curve;
  curve.ink = figures::ink::blue;
  double farthest_mm = 0.0, lowest_mN = 0.0, highest_mN = 0.0;
  for (const analysis::CurvePoint& point : content.insertion.profile.curve) {
    curve.x.push_back(inMillimeters(meters(point.travel)));
    curve.y.push_back(inMillinewtons(newtons(point.force)));
    farthest_mm = std::max(farthest_mm, curve.x.back());
    // a fraction of a millinewton below zero does not need its own tick
    if (curve.y.back() < -0.5) lowest_mN = std::min(lowest_mN, curve.y.back());
    highest_mN = std::max(highest_mN, curve.y.back());
  }
  Figure figure;
  figure.curves = {std::move(curve)};
  figure.x = figures::axisOver(tr("travel, mm").toStdString(), 0.0, farthest_mm);
  figure.y = figures::axisOver(tr("insertion force, mN").toStdString(), lowest_mN, highest_mN);
  return figure;
}

/// The curve in the standard drawing, painted at print resolution.
QImage curveOf(const ReportContent& content)
{
  const figures::Drawing drawing = figures::draw(figureOf(content));
  constexpr double fineness = 4.0;
  QImage image(int(fineness * drawing.width), int(fineness * drawing.height), QImage::Format_RGB32);
  image.fill(Qt::white);
  QPainter painter(&image);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.scale(fineness, fineness);
  paintMarks(painter, drawing, Lettering::scaled);
  return image;
}

}  // namespace

QString askReportFile(const std::filesystem::path& recording, QWidget* parent)
{
  const QString suggested = documentsFolder() + QLatin1Char('/') +
                            QString::fromStdString(recording.stem().string()) +
                            QStringLiteral(".pdf");
  return QFileDialog::getSaveFileName(parent, tr("Report as PDF"), suggested, tr("PDF (*.pdf)"));
}

Result<Done> writeReport(const ReportContent& content, const std::filesystem::path& file)
{
  ReportPages pages;
  pages.title = tr("Insertion report");
  pages.subject = subjectOf(content);
  pages.time = localTimeOf(content.facts.startedUtc);
  pages.paintRecord = [&content](ReportSheet& sheet, const ReportIssuer& issuer,
                                 const ReportArea& area) {
    paintRecord(sheet, content, issuer, area);
  };
  pages.appendix = appendixText(content);
  pages.images = {{QStringLiteral("curve"), curveOf(content)},
                  {QStringLiteral("ct"), ctPictureOf(content.scenario.patient())}};
  return writeReportPages(pages, file);
}

}  // namespace perilymph::gui
