// SPDX-License-Identifier: BSD-3-Clause
#include "gui/pages/sessions/SessionList.h"

#include <QFontMetrics>
#include <QHeaderView>
#include <QSortFilterProxyModel>
#include <algorithm>

#include "gui/pages/sessions/SessionTable.h"
#include "gui/pages/sessions/Thumbnails.h"
#include "gui/widgets/TableRows.h"
#include "gui/widgets/Theme.h"

namespace perilymph::gui {

namespace {

constexpr int rowHeight_px = 60;
constexpr int minColumn_px = 44;
constexpr int cellMargins_px = 24;  // of the style sheet, and the margins in which Qt draws a text

constexpr int narrow_px = 1100;  // where the duration leaves its place to the name

// In the order of SessionTable::Column; more where a text needs it.
constexpr int widths_px[] = {
    Thumbnails::size.width() + 16, 134, 96, 58, 152, 94, 84, 96, 72, 80, 120};
static_assert(std::size(widths_px) == SessionTable::columns);

}  // namespace

SessionList::SessionList(SessionTable& table, QSortFilterProxyModel& sorted, QWidget* parent)
    : QTableView(parent)
{
  setObjectName(QStringLiteral("sessionList"));
  setAccessibleName(tr("Recorded insertions"));
  setModel(&sorted);
  setFont(typeface(13));
  setIconSize({sized(Thumbnails::size.width()), sized(Thumbnails::size.height())});
  showInRows(*this, sized(rowHeight_px));
  setSelectionMode(QAbstractItemView::ExtendedSelection);
  setEditTriggers(QAbstractItemView::EditKeyPressed);
  setWordWrap(false);
  verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);
  QHeaderView* header = horizontalHeader();
  header->setHighlightSections(false);
  header->setSectionsMovable(false);
  header->setMinimumSectionSize(minColumn_px);
  header->setFont(typeface(11));
  for (int column = 0; column < SessionTable::columns; ++column) {
    int width = sized(widths_px[column]);
    for (const QString& text : table.widestTexts(column))
      width = std::max(width, QFontMetrics(font()).horizontalAdvance(text) + cellMargins_px);
    header->resizeSection(column, width);
  }
  header->setSectionResizeMode(SessionTable::picture, QHeaderView::Fixed);
  header->setSectionResizeMode(SessionTable::name, QHeaderView::Stretch);
  connect(header, &QHeaderView::sortIndicatorChanged, &table, &SessionTable::showSorting);
  setSortingEnabled(true);
  sortByColumn(SessionTable::recorded, Qt::DescendingOrder);
}

void SessionList::resizeEvent(QResizeEvent* event)
{
  QTableView::resizeEvent(event);
  setColumnHidden(SessionTable::duration, width() < sized(narrow_px));
}

}  // namespace perilymph::gui
