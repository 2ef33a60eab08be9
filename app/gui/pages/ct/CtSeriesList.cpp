// SPDX-License-Identifier: BSD-3-Clause
#include "gui/pages/ct/CtSeriesList.h"

#include <QIcon>
#include <QImage>
#include <QPixmap>
#include <QStringList>

#include "gui/pages/ct/CtText.h"
#include "gui/text/DataText.h"
#include "gui/widgets/Theme.h"

namespace perilymph::gui {

namespace {

constexpr int height_px = 66, thumbnail_px = 48;

}  // namespace

CtSeriesList::CtSeriesList(QWidget* parent) : QListWidget(parent)
{
  setObjectName(QStringLiteral("ctSeriesList"));
  setAccessibleName(tr("Series"));
  setFont(typeface(12));
  setWordWrap(true);
  setIconSize({thumbnail_px, thumbnail_px});
  setFixedHeight(sized(height_px));
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
}

void CtSeriesList::show(const imaging::CtSeriesList& list)
{
  clear();
  for (const imaging::CtSeries& series : list.series) {
    auto* entry = new QListWidgetItem(seriesText(series), this);
    entry->setData(Qt::UserRole, QString::fromStdString(series.uid));
    QStringList notes;
    for (const Sentence& warning : series.warnings) notes << dataText(warning);
    if (!series.obstacle.empty()) {
      notes.prepend(dataText(series.obstacle));
      entry->setFlags(Qt::NoItemFlags);
    }
    entry->setToolTip(notes.join(QLatin1Char('\n')).toHtmlEscaped());
  }
  setCurrentRow(0);
}

void CtSeriesList::showThumbnails(const std::vector<imaging::CtThumbnail>& pictures)
{
  for (const imaging::CtThumbnail& picture : pictures)
    for (int row = 0; row < count(); ++row) {
      if (uidOf(*item(row)) != picture.uid) continue;
      const QImage image(picture.gray.data(), picture.width, picture.height, picture.width,
                         QImage::Format_Grayscale8);
      item(row)->setIcon(QIcon(QPixmap::fromImage(image)));
    }
}

std::string CtSeriesList::uidOf(const QListWidgetItem& item)
{
  return item.data(Qt::UserRole).toString().toStdString();
}

}  // namespace perilymph::gui
