// SPDX-License-Identifier: BSD-3-Clause
#include "gui/widgets/TableRows.h"

#include <QHeaderView>
#include <QTableView>

namespace perilymph::gui {

void showInRows(QTableView& table, int rowHeight)
{
  table.setShowGrid(false);
  table.setEditTriggers(QAbstractItemView::NoEditTriggers);
  table.setSelectionBehavior(QAbstractItemView::SelectRows);
  table.setTabKeyNavigation(false);
  table.setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
  table.verticalHeader()->hide();
  table.verticalHeader()->setDefaultSectionSize(rowHeight);
}

}  // namespace perilymph::gui
