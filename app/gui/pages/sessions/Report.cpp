// SPDX-License-Identifier: BSD-3-Clause
#include "gui/pages/sessions/Report.h"

#include <QAbstractTextDocumentLayout>
#include <QCoreApplication>
#include <QPageLayout>
#include <QPainter>
#include <QPdfWriter>
#include <QTextDocument>
#include <QUrl>

#include "gui/pages/sessions/ReportText.h"
#include "gui/parts/DrawingPainter.h"
#include "perilymph/foundation/AtomicFile.h"

namespace perilymph::gui {

namespace {

constexpr int dotsPerInch = 144;
constexpr double margin_mm = 18.0;
constexpr int footHeight = 34;  // below the text of a page [dots]

/// The curve in the standard drawing, painted at print resolution.
QImage curveOf(const ReportContent& content)
{
  const figures::Drawing drawing = figures::draw(analysis::comparisonFigure(
      {content.insertion}, content.published ? &*content.published : nullptr));
  constexpr double fineness = 3.0;
  QImage image(int(fineness * drawing.width), int(fineness * drawing.height), QImage::Format_RGB32);
  image.fill(Qt::white);
  QPainter painter(&image);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.scale(fineness, fineness);
  paintMarks(painter, drawing, Lettering::scaled);
  return image;
}

/// Inter replaces some signs between capitals and digits by glyphs without a code: text copied from
/// the PDF would lack them ("SHA 256"). DejaVu Sans has no such glyphs.
QFont reportTypeface(int size_px)
{
  QFont chosen(QStringLiteral("DejaVu Sans"));
  chosen.setPixelSize(size_px);
  return chosen;
}

void paintPages(QPdfWriter& writer, QTextDocument& document)
{
  QPainter painter(&writer);
  const QRectF page(0, 0, writer.width(), writer.height() - footHeight);
  document.setPageSize(page.size());
  const int pages = document.pageCount();
  for (int i = 0; i < pages; ++i) {
    if (i > 0) writer.newPage();
    painter.save();
    painter.translate(0, -i * page.height());
    document.drawContents(&painter, page.translated(0, i * page.height()));
    painter.restore();
    painter.setFont(reportTypeface(13));
    painter.setPen(QColor(90, 90, 90));
    const QRectF place(0, page.height(), page.width(), footHeight);
    painter.drawText(
        place, Qt::AlignLeft | Qt::AlignBottom,
        QCoreApplication::translate("Report", "For research and training. Not a medical device."));
    painter.drawText(place, Qt::AlignRight | Qt::AlignBottom,
                     QCoreApplication::translate("Report", "Page %1 of %2").arg(i + 1).arg(pages));
  }
}

}  // namespace

Result<Done> writeReport(const ReportContent& content, const std::filesystem::path& file)
{
  QTextDocument document;
  document.setDefaultFont(reportTypeface(16));
  document.setDefaultStyleSheet(QStringLiteral(
      "h1 { font-size: 34px; font-weight: 500; } h2 { font-size: 21px; font-weight: 600; }"
      "td { padding: 3px 14px 3px 0; } .quiet { color: #5A5A5A; } .small { font-size: 14px; }"));
  document.addResource(QTextDocument::ImageResource, QUrl(QStringLiteral("curve")),
                       curveOf(content));
  document.addResource(QTextDocument::ImageResource, QUrl(QStringLiteral("picture")),
                       content.picture);
  document.setHtml(reportText(content));
  return writeWhole(file, [&document](const std::filesystem::path& place) {
    QPdfWriter writer(QString::fromStdString(place.string()));
    writer.setResolution(dotsPerInch);
    writer.setPageSize(QPageSize(QPageSize::A4));
    writer.setPageMargins(QMarginsF(margin_mm, margin_mm, margin_mm, margin_mm),
                          QPageLayout::Millimeter);
    writer.setTitle(QCoreApplication::translate("Report", "Insertion report"));
    writer.setCreator(QStringLiteral("Perilymph"));
    document.documentLayout()->setPaintDevice(&writer);
    paintPages(writer, document);
    document.documentLayout()->setPaintDevice(nullptr);  // the writer is destroyed first
    std::error_code failure;
    return std::filesystem::file_size(place, failure) > 0 && !failure;
  });
}

}  // namespace perilymph::gui
