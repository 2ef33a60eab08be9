// SPDX-License-Identifier: BSD-3-Clause
#include "gui/pages/plan/PlanList.h"

#include <QHeaderView>
#include <QKeyEvent>
#include <algorithm>
#include <array>
#include <numeric>

#include "gui/pages/plan/PlanCells.h"
#include "gui/widgets/TableRows.h"
#include "gui/widgets/Theme.h"

namespace perilymph::gui {

namespace {

constexpr int rowHeight_px = 70, headerHeight_px = 66, headMargin_px = 8;

// In the order of PlanColumn; they fit beside the panel on a screen of 1280 pixels.
constexpr int widths_px[] = {96, 84, 80, 82, 82, 86, 92, 66, 80, 68, 66, 78};
static_assert(std::size(widths_px) == std::size_t(planColumns));

}  // namespace

PlanList::PlanList(QWidget* parent) : QTableView(parent), table_(nullptr)
{
  setObjectName(QStringLiteral("planTable"));
  setAccessibleName(tr("Arrays of the plan"));
  sorted_.setSourceModel(&table_);
  sorted_.setSortRole(PlanTable::sortRole);
  setModel(&sorted_);
  setItemDelegate(new PlanCells(table_, sorted_, this));
  setFont(typeface(12));
  showInRows(*this, sized(rowHeight_px));
  setSelectionMode(QAbstractItemView::ExtendedSelection);
  setHorizontalScrollMode(QAbstractItemView::ScrollPerPixel);
  verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);
  QHeaderView* header = horizontalHeader();
  header->setFont(typeface(11));
  header->setFixedHeight(sized(headerHeight_px));
  header->setHighlightSections(false);
  header->setSectionsClickable(true);
  header->setMinimumSectionSize(44);
  connect(header, &QHeaderView::sortIndicatorChanged, &table_, &PlanTable::showSorting);
  setSortingEnabled(true);
  // by name: another order would read as a recommendation
  sortByColumn(int(PlanColumn::array), Qt::AscendingOrder);
  connect(selectionModel(), &QItemSelectionModel::selectionChanged, this,
          &PlanList::selectionMoved);
  connect(this, &QTableView::doubleClicked, this, &PlanList::openRequested);
  fitColumns();
}

void PlanList::show(const PlanWork::SharedPlan& plan)
{
  table_.setPlan(plan);
  fitColumns();
  if (plan && selected().empty() && !plan->arrays.empty()) selectRow(0);
}

std::vector<std::size_t> PlanList::selected() const
{
  std::vector<int> rows;
  for (const QModelIndex& index : selectionModel()->selectedRows()) rows.push_back(index.row());
  std::sort(rows.begin(), rows.end());
  std::vector<std::size_t> arrays;
  for (const int row : rows)
    arrays.push_back(std::size_t(sorted_.mapToSource(sorted_.index(row, 0)).row()));
  return arrays;
}

void PlanList::keyPressEvent(QKeyEvent* event)
{
  if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter) return openRequested();
  QTableView::keyPressEvent(event);
}

void PlanList::resizeEvent(QResizeEvent* event)
{
  QTableView::resizeEvent(event);
  fitColumns();
}

int PlanList::widthOf(int column) const
{
  int width = sized(widths_px[column]);
  // words of a head are not broken
  const QFontMetrics metrics(horizontalHeader()->font());
  for (const QString& word : titleOf(PlanColumn(column)).split(QLatin1Char(' ')))
    width = std::max(width, metrics.horizontalAdvance(word) + 2 * sized(headMargin_px));
  for (int row = 0; row < table_.rowCount(); ++row)
    width = std::max(width, PlanCells::clinicsWidth(table_.array(row), PlanColumn(column)));
  return width;
}

/// Columns share additional width.
void PlanList::fitColumns()
{
  std::array<int, std::size_t(planColumns)> widths{};
  for (int column = 0; column < planColumns; ++column)
    widths[std::size_t(column)] = widthOf(column);
  const int whole = std::accumulate(widths.begin(), widths.end(), 0);
  const double factor = std::max(1.0, double(viewport()->width()) / whole);
  for (int column = 0; column < planColumns; ++column)
    horizontalHeader()->resizeSection(column, int(factor * widths[std::size_t(column)]));
}

}  // namespace perilymph::gui
