// SPDX-License-Identifier: BSD-3-Clause
#include "gui/report/KeyImagePages.h"

#include <QCoreApplication>
#include <algorithm>
#include <memory>

#include "gui/setup/CtKeyImages.h"

namespace perilymph::gui {

namespace {

constexpr std::size_t onOnePage = 2;
constexpr double width_mm = 130.0, height_mm = width_mm * keyImageHeight_px / keyImageWidth_px;
constexpr double gap_mm = 5.0;

// lupdate assigns texts of free functions to their namespace.
QString tr(const char* text) { return QCoreApplication::translate("perilymph::gui", text); }

}  // namespace

void addKeyImagePages(ReportPages& pages, const std::string& seriesKey)
{
  const auto images = std::make_shared<const std::vector<CtKeyImage>>(ctKeyImages(seriesKey));
  for (std::size_t first = 0; first < images->size(); first += onOnePage)
    pages.figures.push_back([images, first](ReportSheet& sheet, const ReportArea& area) {
      double y_mm = sheet.heading(0.0, area.top_mm, area.width_mm, tr("Key images of the CT"));
      for (std::size_t k = first; k < std::min(first + onOnePage, images->size()); ++k) {
        const CtKeyImage& each = (*images)[k];
        const QImage picture(QString::fromStdString(each.file.string()));
        sheet.painter().drawImage(sheet.dots({0.0, y_mm, width_mm, height_mm}), picture);
        y_mm += height_mm + 1.0;
        const QString name = tr("Key image %1").arg(k + 1);
        y_mm += sheet.paragraph(
            0.0, y_mm, area.width_mm,
            each.caption.isEmpty() ? name : QStringLiteral("%1: %2").arg(name, each.caption),
            ReportFace::text);
        y_mm += sheet.paragraph(0.0, y_mm, area.width_mm, each.place, ReportFace::quiet) + gap_mm;
      }
    });
}

}  // namespace perilymph::gui
