// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The sortable list of a plan's arrays.

#include <QTableView>
#include <vector>

#include "gui/pages/plan/PlanTable.h"

namespace perilymph::gui {

/// One row per array. Several rows can be selected with Ctrl and Shift.
class PlanList : public QTableView {
  Q_OBJECT
public:
  explicit PlanList(QWidget* parent);

  /// Shows a plan; the selected arrays and the order remain where it has them.
  void show(const PlanWork::SharedPlan& plan);
  /// Indices of the selected arrays in the plan, in the order of the rows.
  std::vector<std::size_t> selected() const;

Q_SIGNALS:
  void selectionMoved();
  /// Return or a double click.
  void openRequested();

protected:
  void keyPressEvent(QKeyEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

private:
  /// Width that a column needs: its usual one, or that of a word of its head or of what clinics report.
  int widthOf(int column) const;
  void fitColumns();

  PlanTable table_;
  QSortFilterProxyModel sorted_;
};

}  // namespace perilymph::gui
