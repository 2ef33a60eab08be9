// SPDX-License-Identifier: BSD-3-Clause
#include "gui/pages/start/PatientHistoryList.h"

#include <QHeaderView>
#include <QKeyEvent>
#include <utility>

#include "gui/widgets/TableRows.h"
#include "gui/widgets/Theme.h"

namespace perilymph::gui {

namespace {

constexpr int row_px = 28;
constexpr int dateColumn = 0, whatColumn = 1, valuesColumn = 2, columns = 3;
constexpr int dateWidth_px = 138, whatWidth_px = 84;

}  // namespace

PatientHistoryList::PatientHistoryList(QWidget* parent) : QTableWidget(0, columns, parent)
{
  setObjectName(QStringLiteral("patientHistory"));
  setAccessibleName(tr("Scans, plans, insertions and outcomes"));
  setFont(typeface(12));
  showInRows(*this, sized(row_px));
  setSelectionMode(QAbstractItemView::SingleSelection);
  setWordWrap(false);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  horizontalHeader()->hide();
  horizontalHeader()->resizeSection(dateColumn, sized(dateWidth_px));
  horizontalHeader()->resizeSection(whatColumn, sized(whatWidth_px));
  horizontalHeader()->setSectionResizeMode(valuesColumn, QHeaderView::Stretch);
  viewport()->setCursor(Qt::PointingHandCursor);
  connect(this, &QTableWidget::cellClicked, this, [this](int row, int) { open(row); });
}

void PatientHistoryList::show(std::vector<HistoryEntry> entries)
{
  entries_ = std::move(entries);
  clearSelection();
  setRowCount(int(entries_.size()));
  for (int row = 0; row < rowCount(); ++row) {
    const HistoryEntry& each = entries_[std::size_t(row)];
    const QString texts[columns] = {localTimeText(each.utc), each.what, each.values};
    for (int column = 0; column < columns; ++column) {
      auto* item = new QTableWidgetItem(texts[column]);
      item->setToolTip(QStringLiteral("%1\n%2")
                           .arg(texts[valuesColumn], each.detail)
                           .toHtmlEscaped()
                           .replace(QLatin1Char('\n'), QLatin1String("<br>")));
      setItem(row, column, item);
    }
  }
}

void PatientHistoryList::open(int row)
{
  if (row < 0 || row >= int(entries_.size())) return;
  const HistoryEntry entry = entries_[std::size_t(row)];  // the list may be read again meanwhile
  Q_EMIT opened(entry);
}

void PatientHistoryList::keyPressEvent(QKeyEvent* event)
{
  if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter) return open(currentRow());
  QTableWidget::keyPressEvent(event);
}

void PatientHistoryList::focusInEvent(QFocusEvent* event)
{
  QTableWidget::focusInEvent(event);
  const bool isByKey =
      event->reason() == Qt::TabFocusReason || event->reason() == Qt::BacktabFocusReason;
  if (isByKey && selectedItems().isEmpty() && rowCount() > 0) selectRow(0);
}

}  // namespace perilymph::gui
