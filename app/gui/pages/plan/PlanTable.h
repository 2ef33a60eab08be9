// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// A plan as a table: one row per array.

#include <QAbstractTableModel>
#include <QSortFilterProxyModel>

#include "gui/pages/plan/PlanText.h"
#include "gui/pages/plan/PlanWork.h"

namespace perilymph::gui {

/// The rows of a plan. Values are texts with units for readers of the screen, and numbers for
/// sorting under `sortRole`.
class PlanTable : public QAbstractTableModel {
  Q_OBJECT
public:
  static constexpr int sortRole = Qt::UserRole;

  explicit PlanTable(QObject* parent) : QAbstractTableModel(parent) {}

  void setPlan(const PlanWork::SharedPlan& plan);
  const PlanWork::SharedPlan& plan() const { return plan_; }
  /// The array in a row.
  const planning::ArrayPlan& array(int row) const { return plan_->arrays[std::size_t(row)]; }

  /// Axes that all rows share.
  struct Axes {
    double angle_deg = 0.0, force_mN = 0.0, partition_mN = 0.0, depth_mm = 0.0;
  };
  const Axes& axes() const { return axes_; }

  /// Marks the column by which the rows are sorted.
  void showSorting(int column, Qt::SortOrder order);

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

private:
  QString text(const planning::ArrayPlan& array, PlanColumn column) const;
  QString toolTip(const planning::ArrayPlan& array, PlanColumn column) const;
  QVariant sortValue(const planning::ArrayPlan& array, PlanColumn column) const;

  PlanWork::SharedPlan plan_;
  Axes axes_;
  int sortedBy_ = -1;
  Qt::SortOrder order_ = Qt::DescendingOrder;
};

}  // namespace perilymph::gui
