// SPDX-License-Identifier: BSD-3-Clause
#include "gui/report/ReportPages.h"

#include <QAbstractTextDocumentLayout>
#include <QCoreApplication>
#include <QPageLayout>
#include <QPainter>
#include <QPdfWriter>
#include <QTextDocument>
#include <QUrl>
#include <algorithm>
#include <cmath>

#include "gui/widgets/Theme.h"
#include "perilymph/figures/FixedInks.h"
#include "perilymph/foundation/AtomicFile.h"

namespace perilymph::gui {

namespace {

constexpr int dotsPerInch = 288;
constexpr double perInch_mm = 25.4;
constexpr double margin_mm = 15.0;
constexpr double head_mm = 9.0;  // the line on top of every page
constexpr double foot_mm = 7.0;
constexpr double row_mm = 4.7;
constexpr double appendixText_pt = 8.0;                     // smaller, print is not read
constexpr double logoHeight_mm = 8.5, logoWidth_mm = 45.0;  // at most

// lupdate assigns texts of free functions to their namespace.
QString tr(const char* text) { return QCoreApplication::translate("perilymph::gui", text); }

double dotsOf(double length_mm) { return length_mm * dotsPerInch / perInch_mm; }

/// Sizes of the appendix's text [dots].
QString styleSheet()
{
  const auto dots = [](double points) { return int(std::lround(points * dotsPerInch / 72.0)); };
  return QStringLiteral(
             "h1 { font-size: %1px; font-weight: 600; margin-top: 0; } "
             "h2 { font-size: %2px; font-weight: 600; margin-top: 10px; margin-bottom: 3px; } "
             "td { padding: 1px 10px 1px 0; } .quiet { color: %3; } "
             "td.tight { padding: 0 3px 0 0; }")
      .arg(dots(13.0))
      .arg(dots(10.0))
      .arg(colorOf(figures::ink::quiet).name());
}

QString pageText(int page, int pages) { return tr("Page %1 of %2").arg(page).arg(pages); }

QString purposeText() { return tr("For research and training. Not a medical device."); }

/// The lines on top and at the foot of every page.
class PageFrame {
public:
  PageFrame(const ReportPages& report, const ReportIssuer& issuer, double width_mm,
            double height_mm)
      : report_(report), issuer_(issuer), width_mm_(width_mm), height_mm_(height_mm)
  {
  }

  void paint(ReportSheet& sheet, int page, int pages) const
  {
    sheet.line({0.0, 0.0, 0.6 * width_mm_, 5.0}, report_.subject, ReportFace::bold);
    sheet.line({0.6 * width_mm_, 0.0, 0.4 * width_mm_, 5.0},
               issuer_.institution.isEmpty() ? QStringLiteral("Perilymph") : issuer_.institution,
               ReportFace::quiet, Qt::AlignRight);
    sheet.rule(0.0, 5.8, width_mm_);
    const QRectF foot(0.0, height_mm_ - 4.0, width_mm_, 4.0);
    sheet.line(foot, purposeText(), ReportFace::quiet);
    sheet.line({0.5 * width_mm_, foot.top(), 0.36 * width_mm_, foot.height()}, report_.time,
               ReportFace::quiet, Qt::AlignHCenter);
    sheet.line(foot, pageText(page, pages), ReportFace::quiet, Qt::AlignRight);
  }

private:
  const ReportPages& report_;
  const ReportIssuer& issuer_;
  double width_mm_, height_mm_;
};

/// The logo at the right of the title.
void paintLogo(ReportSheet& sheet, const QImage& logo, double width_mm)
{
  if (logo.isNull()) return;
  const double scale = std::min(logoHeight_mm / logo.height(), logoWidth_mm / logo.width());
  const double wide_mm = scale * logo.width(), high_mm = scale * logo.height();
  sheet.painter().drawImage(sheet.dots({width_mm - wide_mm, head_mm - 1.0, wide_mm, high_mm}),
                            logo);
}

void paintPages(QPdfWriter& writer, QTextDocument& appendix, const ReportPages& report)
{
  const ReportIssuer issuer = ReportIssuer::fromSettings();
  const double width_mm = writer.width() * perInch_mm / dotsPerInch;
  const double height_mm = writer.height() * perInch_mm / dotsPerInch;
  const PageFrame frame(report, issuer, width_mm, height_mm);
  const double textHeight = writer.height() - dotsOf(head_mm) - dotsOf(foot_mm);
  const int painted = 1 + int(report.figures.size());
  const ReportArea area{head_mm, height_mm - foot_mm, width_mm};

  QPainter painter(&writer);
  painter.setRenderHint(QPainter::LosslessImageRendering);
  ReportSheet sheet(painter, dotsPerInch);
  paintLogo(sheet, issuer.logo, width_mm);
  report.paintRecord(sheet, issuer, area);
  if (report.appendix) appendix.setHtml(report.appendix());  // it lists what the record cites
  appendix.setPageSize({double(writer.width()), textHeight});
  const int flowing = report.appendix ? appendix.pageCount() : 0;
  const int pages = painted + flowing;
  frame.paint(sheet, 1, pages);
  for (int i = 1; i < painted; ++i) {
    writer.newPage();
    frame.paint(sheet, i + 1, pages);
    report.figures[std::size_t(i - 1)](sheet, area);
  }
  for (int i = 0; i < flowing; ++i) {
    writer.newPage();
    frame.paint(sheet, painted + i + 1, pages);
    painter.save();
    painter.translate(0.0, dotsOf(head_mm) - i * textHeight);
    appendix.drawContents(&painter, QRectF(0.0, i * textHeight, writer.width(), textHeight));
    painter.restore();
  }
}

}  // namespace

Result<void> writeReportPages(const ReportPages& report, const std::filesystem::path& file)
{
  QTextDocument appendix;
  appendix.setDocumentMargin(0.0);
  appendix.setDefaultFont(reportFont(appendixText_pt * dotsPerInch / 72.0));
  appendix.setDefaultStyleSheet(styleSheet());
  for (const auto& [name, image] : report.images)
    appendix.addResource(QTextDocument::ImageResource, QUrl(name), image);
  return writeWhole(file, [&](const std::filesystem::path& place) {
    QPdfWriter writer(QString::fromStdString(place.string()));
    writer.setResolution(dotsPerInch);
    writer.setPageSize(QPageSize(QPageSize::A4));
    writer.setPageMargins(QMarginsF(margin_mm, margin_mm, margin_mm, margin_mm),
                          QPageLayout::Millimeter);
    writer.setTitle(report.title);
    writer.setCreator(QStringLiteral("Perilymph"));
    appendix.documentLayout()->setPaintDevice(&writer);
    paintPages(writer, appendix, report);
    appendix.documentLayout()->setPaintDevice(nullptr);  // the writer is destroyed first
    std::error_code failure;
    return std::filesystem::file_size(place, failure) > 0 && !failure;
  });
}

double paintReportTitle(ReportSheet& sheet, const QString& title, const ReportArea& area)
{
  const double width_mm = area.width_mm - logoWidth_mm;
  sheet.line({0.0, area.top_mm, width_mm, 8.0}, title, ReportFace::title);
  sheet.line({0.0, area.top_mm + 8.6, area.width_mm, 4.0},
             tr("Simulation for research and training. Not a medical device; must not be used for "
                "patient care."),
             ReportFace::quiet);
  return area.top_mm + 14.6;
}

double paintEntries(ReportSheet& sheet, const std::vector<ReportEntry>& entries, double x_mm,
                    double y_mm, double width_mm)
{
  constexpr double name_mm = 27.0;
  for (const ReportEntry& entry : entries) {
    sheet.line({x_mm, y_mm, name_mm, row_mm}, entry.name, ReportFace::quiet);
    const double left_mm = x_mm + name_mm;
    if (entry.value.isEmpty())
      sheet.rule(left_mm, y_mm + row_mm - 0.8, width_mm - name_mm);
    else
      sheet.line({left_mm, y_mm, width_mm - name_mm, row_mm}, entry.value, ReportFace::text);
    y_mm += row_mm;
  }
  return y_mm;
}

void paintSignature(ReportSheet& sheet, double y_mm, const ReportArea& area)
{
  y_mm = std::max(y_mm + 10.0, area.bottom_mm - 6.0);
  const double line_mm = 0.29 * area.width_mm, step_mm = 0.355 * area.width_mm;
  const QString names[] = {tr("Date"), tr("Name"), tr("Signature")};
  for (int i = 0; i < 3; ++i) {
    sheet.rule(i * step_mm, y_mm, line_mm);
    sheet.line({i * step_mm, y_mm + 0.6, line_mm, 4.0}, names[i], ReportFace::quiet);
  }
}

}  // namespace perilymph::gui
