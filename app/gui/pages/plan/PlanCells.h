// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Painting of a plan's table: bands, probabilities and force curves in their cells.

#include <QStyledItemDelegate>
#include <optional>

#include "gui/pages/plan/CoverageReference.h"
#include "gui/pages/plan/PlanTable.h"

namespace perilymph::gui {

/// Paints a number with its unit, and below it the band on the column's common axis.
class PlanCells : public QStyledItemDelegate {
  Q_OBJECT
public:
  /// @param table   Its rows; the view may show them in another order.
  /// What clinics report of an array, in the column's cell: "clin. 45–102"; may be empty.
  static QString clinicsText(const planning::ArrayPlan& array, PlanColumn column);
  /// Width that this text and the cell's margins need [pixels].
  static int clinicsWidth(const planning::ArrayPlan& array, PlanColumn column);

  PlanCells(const PlanTable& table, const QSortFilterProxyModel& sorted, QObject* parent);

  void paint(QPainter* painter, const QStyleOptionViewItem& option,
             const QModelIndex& index) const override;

private:
  void paintBand(QPainter& painter, const QRectF& place, const planning::Band& band,
                 PlanColumn column) const;
  void paintProbability(QPainter& painter, const QRectF& place, const analysis::Estimate& estimate,
                        std::size_t draws) const;
  void paintCurve(QPainter& painter, const QRectF& place, const planning::ArrayPlan& array) const;
  double limitOf(PlanColumn column) const;

  const PlanTable& table_;
  const QSortFilterProxyModel& sorted_;
  std::optional<CoverageReference> coverage_;
};

}  // namespace perilymph::gui
