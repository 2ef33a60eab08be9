// SPDX-License-Identifier: BSD-3-Clause
#include "gui/widgets/TableHeads.h"

#include <QHeaderView>
#include <QTableWidget>
#include <algorithm>

#include "gui/widgets/TableRows.h"
#include "gui/widgets/Theme.h"

namespace perilymph::gui {

void showValues(QTableWidget& table, std::span<const std::pair<QString, QString>> heads,
                int rowHeight, int headerHeight)
{
  constexpr int narrowest_px = 24;  // a number of two digits
  table.setFont(typeface(11));
  showInRows(table, rowHeight);
  table.setSelectionMode(QAbstractItemView::SingleSelection);
  table.setWordWrap(false);
  table.setHorizontalScrollMode(QAbstractItemView::ScrollPerPixel);
  QHeaderView& header = *table.horizontalHeader();
  header.setFont(typeface(11));
  header.setFixedHeight(headerHeight);
  header.setHighlightSections(false);
  header.setMinimumSectionSize(narrowest_px);
  header.setDefaultAlignment(
      Qt::Alignment(int(Qt::AlignLeft | Qt::AlignBottom) | int(Qt::TextWordWrap)));
  for (std::size_t column = 0; column < heads.size(); ++column) {
    auto* head = new QTableWidgetItem(heads[column].first);
    head->setToolTip(heads[column].second);
    table.setHorizontalHeaderItem(int(column), head);
  }
}

void fitColumns(QTableWidget& table, std::span<const int> widths_px)
{
  const QAbstractItemView& view = table;  // of which the hints are public
  for (int column = 0; column < table.columnCount(); ++column)
    table.horizontalHeader()->resizeSection(
        column, std::max(sized(widths_px[std::size_t(column)]), view.sizeHintForColumn(column)));
}

}  // namespace perilymph::gui
