// SPDX-License-Identifier: BSD-3-Clause
#include "gui/pages/sessions/Report.h"

#include <QAbstractTextDocumentLayout>
#include <QCoreApplication>
#include <QPageLayout>
#include <QPainter>
#include <QPdfWriter>
#include <QTextDocument>
#include <QUrl>
#include <algorithm>
#include <cmath>

#include "gui/pages/sessions/ReportHead.h"
#include "gui/pages/sessions/ReportRecord.h"
#include "gui/pages/sessions/ReportSheet.h"
#include "gui/pages/sessions/ReportText.h"
#include "gui/parts/DrawingPainter.h"
#include "perilymph/figures/Figure.h"
#include "perilymph/foundation/AtomicFile.h"

namespace perilymph::gui {

namespace {

constexpr int dotsPerInch = 288;
constexpr double perInch_mm = 25.4;
constexpr double margin_mm = 15.0;
constexpr double head_mm = 9.0;  // the line on top of every page
constexpr double foot_mm = 7.0;

// lupdate assigns texts of free functions to their namespace.
QString tr(const char* text) { return QCoreApplication::translate("perilymph::gui", text); }

double dotsOf(double length_mm) { return length_mm * dotsPerInch / perInch_mm; }

/// Insertion force in mN over travel.
figures::Figure figureOf(const ReportContent& content)
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
  figures::Figure figure;
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

/// Sizes of the appendix's text [dots].
QString styleSheet()
{
  const auto dots = [](double points) { return int(std::lround(points * dotsPerInch / 72.0)); };
  return QStringLiteral(
             "h1 { font-size: %1px; font-weight: 600; margin-top: 0; } "
             "h2 { font-size: %2px; font-weight: 600; margin-top: 10px; margin-bottom: 3px; } "
             "td { padding: 1px 10px 1px 0; } .quiet { color: #4A5661; } "
             ".small { font-size: %3px; }")
      .arg(dots(13.0))
      .arg(dots(10.0))
      .arg(dots(7.0));
}

QString pageText(int page, int pages) { return tr("Page %1 of %2").arg(page).arg(pages); }

QString purposeText() { return tr("For research and training. Not a medical device."); }

/// The lines on top and at the foot of every page.
class PageFrame {
public:
  PageFrame(const ReportContent& content, const ReportIssuer& issuer, double width_mm,
            double height_mm)
      : subject_(subjectOf(content)),
        issuer_(issuer),
        time_(localTimeOf(content.facts.startedUtc)),
        width_mm_(width_mm),
        height_mm_(height_mm)
  {
  }

  void paint(ReportSheet& sheet, int page, int pages) const
  {
    sheet.line({0.0, 0.0, 0.6 * width_mm_, 5.0}, subject_, ReportFace::bold);
    sheet.line({0.6 * width_mm_, 0.0, 0.4 * width_mm_, 5.0},
               issuer_.institution.isEmpty() ? QStringLiteral("Perilymph") : issuer_.institution,
               ReportFace::quiet, Qt::AlignRight);
    sheet.rule(0.0, 5.8, width_mm_);
    const QRectF foot(0.0, height_mm_ - 4.0, width_mm_, 4.0);
    sheet.line(foot, purposeText(), ReportFace::quiet);
    sheet.line(foot, time_, ReportFace::quiet, Qt::AlignHCenter);
    sheet.line(foot, pageText(page, pages), ReportFace::quiet, Qt::AlignRight);
  }

private:
  QString subject_;
  const ReportIssuer& issuer_;
  QString time_;
  double width_mm_, height_mm_;
};

void paintPages(QPdfWriter& writer, QTextDocument& appendix, const ReportContent& content)
{
  const ReportIssuer issuer = ReportIssuer::fromSettings();
  const double width_mm = writer.width() * perInch_mm / dotsPerInch;
  const double height_mm = writer.height() * perInch_mm / dotsPerInch;
  const PageFrame frame(content, issuer, width_mm, height_mm);
  const double textHeight = writer.height() - dotsOf(head_mm) - dotsOf(foot_mm);
  appendix.setPageSize({double(writer.width()), textHeight});
  const int pages = 1 + appendix.pageCount();

  QPainter painter(&writer);
  painter.setRenderHint(QPainter::LosslessImageRendering);
  ReportSheet sheet(painter, dotsPerInch);
  frame.paint(sheet, 1, pages);
  paintRecord(sheet, content, issuer, head_mm, height_mm - foot_mm, width_mm);
  for (int i = 0; i + 1 < pages; ++i) {
    writer.newPage();
    frame.paint(sheet, i + 2, pages);
    painter.save();
    painter.translate(0.0, dotsOf(head_mm) - i * textHeight);
    appendix.drawContents(&painter, QRectF(0.0, i * textHeight, writer.width(), textHeight));
    painter.restore();
  }
}

}  // namespace

Result<Done> writeReport(const ReportContent& content, const std::filesystem::path& file)
{
  QTextDocument appendix;
  appendix.setDocumentMargin(0.0);
  appendix.setDefaultFont(reportFont(8.0 * dotsPerInch / 72.0));
  appendix.setDefaultStyleSheet(styleSheet());
  appendix.addResource(QTextDocument::ImageResource, QUrl(QStringLiteral("curve")),
                       curveOf(content));
  appendix.setHtml(appendixText(content));
  return writeWhole(file, [&](const std::filesystem::path& place) {
    QPdfWriter writer(QString::fromStdString(place.string()));
    writer.setResolution(dotsPerInch);
    writer.setPageSize(QPageSize(QPageSize::A4));
    writer.setPageMargins(QMarginsF(margin_mm, margin_mm, margin_mm, margin_mm),
                          QPageLayout::Millimeter);
    writer.setTitle(tr("Insertion report"));
    writer.setCreator(QStringLiteral("Perilymph"));
    appendix.documentLayout()->setPaintDevice(&writer);
    paintPages(writer, appendix, content);
    appendix.documentLayout()->setPaintDevice(nullptr);  // the writer is destroyed first
    std::error_code failure;
    return std::filesystem::file_size(place, failure) > 0 && !failure;
  });
}

}  // namespace perilymph::gui
