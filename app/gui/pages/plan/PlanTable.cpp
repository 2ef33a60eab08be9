// SPDX-License-Identifier: BSD-3-Clause
#include "gui/pages/plan/PlanTable.h"

#include <algorithm>
#include <cmath>

#include "gui/setup/PlannedFriction.h"
#include "gui/text/ClinicalText.h"

namespace perilymph::gui {

namespace {

/// The next multiple of a step.
double roundedUp(double value, double step)
{
  return step * std::ceil(std::max(value, step) / step);
}

}  // namespace

void PlanTable::setPlan(const PlanWork::SharedPlan& plan)
{
  const bool hasSameRows = plan_ && plan && plan->request.arrays == plan_->request.arrays;
  if (!hasSameRows) beginResetModel();
  plan_ = plan;
  axes_ = {};
  Q_EMIT headerDataChanged(Qt::Horizontal, 0, planColumns - 1);
  if (plan) {
    for (const planning::ArrayPlan& each : plan->arrays) {
      axes_.angle_deg = std::max(axes_.angle_deg, each.angle_deg.high);
      axes_.force_mN = std::max({axes_.force_mN, each.peak_mN.high, each.end_mN.high});
      axes_.partition_mN = std::max(axes_.partition_mN, each.partition_mN.high);
      if (!each.force.empty())
        axes_.depth_mm = std::max(axes_.depth_mm, each.force.back().depth_mm);
    }
  }
  axes_.angle_deg = roundedUp(axes_.angle_deg, 90.0);
  axes_.force_mN = roundedUp(axes_.force_mN, 10.0);
  axes_.partition_mN = roundedUp(axes_.partition_mN, 1.0);
  axes_.depth_mm = roundedUp(axes_.depth_mm, 1.0);
  if (!hasSameRows) return endResetModel();
  Q_EMIT dataChanged(index(0, 0), index(rowCount() - 1, planColumns - 1));
}

void PlanTable::showSorting(int column, Qt::SortOrder order)
{
  sortedBy_ = column;
  order_ = order;
  Q_EMIT headerDataChanged(Qt::Horizontal, 0, planColumns - 1);
}

int PlanTable::rowCount(const QModelIndex& parent) const
{
  return parent.isValid() || !plan_ ? 0 : int(plan_->arrays.size());
}

int PlanTable::columnCount(const QModelIndex& parent) const
{
  return parent.isValid() ? 0 : planColumns;
}

QString PlanTable::text(const planning::ArrayPlan& array, PlanColumn column) const
{
  switch (kindOf(column)) {
    case PlanCellKind::name:
      return QString::fromStdString(array.name);
    case PlanCellKind::band:
      return bandText(bandOf(array, column), column);
    case PlanCellKind::probability:
      return shownShareAndInterval(estimateOf(array, column), array.draws);
    case PlanCellKind::curve:
      break;
  }
  return tr("peak %1").arg(bandText(array.peak_mN, PlanColumn::peak));
}

QString PlanTable::toolTip(const planning::ArrayPlan& array, PlanColumn column) const
{
  QStringList lines{
      tr("%1, %2: %3. %4 simulations")
          .arg(QString::fromStdString(array.name), titleOf(column), text(array, column))
          .arg(array.draws)};
  if (const auto reported = reportedOf(column))
    if (const QString details = clinicsReportDetails(array.array, *reported); !details.isEmpty())
      lines << details;
  if (const QString note = verdictNote(array.array); !note.isEmpty()) lines << note;
  return lines.join(QLatin1Char('\n'));
}

QVariant PlanTable::sortValue(const planning::ArrayPlan& array, PlanColumn column) const
{
  switch (kindOf(column)) {
    case PlanCellKind::name:
      return QString::fromStdString(array.name);
    case PlanCellKind::band:
      return bandOf(array, column).median;
    case PlanCellKind::probability:
      return estimateOf(array, column).value;
    case PlanCellKind::curve:
      break;
  }
  return array.force.empty() ? 0.0 : array.force.back().depth_mm;
}

QVariant PlanTable::data(const QModelIndex& index, int role) const
{
  if (!index.isValid() || !plan_) return {};
  const planning::ArrayPlan& array = this->array(index.row());
  const auto column = static_cast<PlanColumn>(index.column());
  switch (role) {
    case Qt::DisplayRole:
      return text(array, column);
    case Qt::AccessibleTextRole: {
      const QString shown = tr("%1: %2").arg(titleOf(column), text(array, column));
      const auto reported = reportedOf(column);
      const QString clinics = reported ? clinicsReport(array.array, *reported) : QString();
      return clinics.isEmpty() ? shown : tr("%1; clinics report %2").arg(shown, clinics);
    }
    case sortRole:
      return sortValue(array, column);
    case Qt::ToolTipRole:
      return toolTip(array, column);
    default:
      return {};
  }
}

QVariant PlanTable::headerData(int section, Qt::Orientation orientation, int role) const
{
  if (orientation != Qt::Horizontal || section < 0 || section >= planColumns) return {};
  const auto column = static_cast<PlanColumn>(section);
  switch (role) {
    case Qt::DisplayRole: {
      QString head = titleOf(column);
      if (section == sortedBy_)
        head += QLatin1Char(' ') + (order_ == Qt::AscendingOrder ? QChar(0x25b4) : QChar(0x25be));
      return head;
    }
    case Qt::ToolTipRole:
      return methodOf(column);
    case Qt::TextAlignmentRole:
      return int(Qt::AlignLeft | Qt::AlignBottom) | int(Qt::TextWordWrap);
    default:
      return {};
  }
}

}  // namespace perilymph::gui
