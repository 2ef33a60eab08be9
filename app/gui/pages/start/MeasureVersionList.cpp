// SPDX-License-Identifier: BSD-3-Clause
#include "gui/pages/start/MeasureVersionList.h"

#include <QDateTime>
#include <QHeaderView>
#include <algorithm>

#include "gui/widgets/TableRows.h"
#include "gui/widgets/Theme.h"

namespace perilymph::gui {

namespace {

constexpr int versionRow_px = 24, maxShown = 4;
constexpr int howColumn = 1, firstMeasure = 2;

QString dayOf(const MeasureVersion& version)
{
  const auto utc = QDateTime::fromString(QString::fromStdString(version.utc), Qt::ISODate);
  return utc.isValid() ? utc.toLocalTime().toString(QStringLiteral("yyyy-MM-dd"))
                       : QStringLiteral("–");
}

}  // namespace

MeasureVersionList::MeasureVersionList(QWidget* parent) : QTableWidget(0, 0, parent)
{
  setObjectName(QStringLiteral("measureVersions"));
  setAccessibleName(tr("Measures of this ear, the newest first"));
  setFont(typeface(11));
  showInRows(*this, sized(versionRow_px));
  setSelectionMode(QAbstractItemView::NoSelection);
  setFocusPolicy(Qt::NoFocus);
  setWordWrap(false);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  QStringList heads{tr("Saved"), tr("How")};
  for (const QString& each : comparedNames()) heads << tr("%1, mm").arg(each);
  setColumnCount(int(heads.size()));
  setHorizontalHeaderLabels(heads);
  horizontalHeader()->setFont(typeface(11));
  horizontalHeader()->setHighlightSections(false);
  horizontalHeader()->setMinimumSectionSize(24);
  horizontalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
}

void MeasureVersionList::show(const std::vector<MeasureVersion>& versions)
{
  const auto used = std::ranges::find_if(versions, &MeasureVersion::isUsed);
  setRowCount(int(versions.size()));
  for (int row = 0; row < rowCount(); ++row) {
    const MeasureVersion& each = versions[std::size_t(row)];
    const ComparedMeasures measures = comparedOf(each.patient);
    QStringList texts{dayOf(each), each.isUsed ? tr("in use: %1").arg(each.how) : each.how};
    for (std::size_t k = 0; k < measures.size(); ++k) texts << comparedText(measures[k], k);
    for (int column = 0; column < texts.size(); ++column) {
      auto* item = new QTableWidgetItem(texts[column]);
      item->setToolTip(texts[column].toHtmlEscaped());
      if (each.isUsed) item->setFont(typeface(11, QFont::DemiBold));
      if (column >= firstMeasure && !each.isUsed && used != versions.end()) {
        const auto k = std::size_t(column - firstMeasure);
        const MeasureDifference difference =
            differenceOf(measures[k], comparedOf(used->patient)[k], k);
        if (difference.isBeyond) item->setForeground(shownTheme().warning);
        if (!difference.detail.isEmpty())
          item->setToolTip(tr("In use: %1 mm. %2").arg(difference.text, difference.detail));
      }
      setItem(row, column, item);
    }
  }
  for (int column = 0; column < columnCount(); ++column)
    horizontalHeader()->setSectionResizeMode(
        column, column == howColumn ? QHeaderView::Stretch : QHeaderView::ResizeToContents);
  setFixedHeight(horizontalHeader()->sizeHint().height() +
                 std::min(maxShown, rowCount()) * sized(versionRow_px) + 2 * frameWidth() + 2);
}

}  // namespace perilymph::gui
