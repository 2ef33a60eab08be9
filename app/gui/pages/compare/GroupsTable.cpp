// SPDX-License-Identifier: BSD-3-Clause
#include "gui/pages/compare/GroupsTable.h"

#include <QHeaderView>
#include <QLocale>
#include <QPixmap>

#include "gui/pages/compare/ComparisonPlot.h"
#include "gui/pages/compare/RunsTable.h"
#include "gui/setup/Catalog.h"
#include "gui/text/DataText.h"
#include "gui/text/Numbers.h"
#include "gui/widgets/TableRows.h"
#include "gui/widgets/Theme.h"

namespace perilymph::gui {

namespace {

constexpr int groupRow_px = 22;

/// A value of a key in the language of the window: techniques and frictions by their titles there.
QString valueText(const std::string& value, analysis::GroupKey key)
{
  const QString text = QString::fromStdString(value);
  if (key == analysis::GroupKey::technique) return techniqueText(value);
  if (key == analysis::GroupKey::speed) {
    const QString number = text.section(QLatin1Char(' '), 0, 0);
    bool isNumber = false;
    const double speed = number.toDouble(&isNumber);
    return isNumber ? GroupsTable::tr("%1 mm/s").arg(numberText(speed, 2))
                    : GroupsTable::tr("by hand");
  }
  if (key == analysis::GroupKey::friction) {
    QString coefficient = text.section(QStringLiteral(" ("), 0, 0);
    coefficient.replace(QLatin1Char('.'), QLocale().decimalPoint());
    for (const CatalogFriction& friction : catalogFrictions())
      if (text.endsWith(QStringLiteral("(%1)").arg(friction.name)))
        return GroupsTable::tr("%1 (%2)").arg(coefficient, friction.title);
    return GroupsTable::tr("%1 (own value)").arg(coefficient);
  }
  return text;
}

QString withUnit(const QString& text, const QString& unit)
{
  if (unit.isEmpty()) return text;
  return unit == QStringLiteral("°") ? text + unit : text + QLatin1Char(' ') + unit;
}

/// "74 ± 8 mN": mean and standard deviation; the value alone of one insertion.
QString meanText(const std::vector<double>& values, double factor, int decimals,
                 const QString& unit)
{
  if (values.empty()) return QStringLiteral("–");
  const analysis::SampleStatistics sample = analysis::statisticsOf(values);
  const QString mean = numberText(factor * sample.mean, decimals);
  if (values.size() < 2) return withUnit(mean, unit);
  return withUnit(
      GroupsTable::tr("%1 ± %2").arg(mean, numberText(factor * sample.standardDeviation, decimals)),
      unit);
}

/// "12 (3 to 21) mN"; without an interval the difference alone, and why.
QString differenceText(const std::vector<double>& one, const std::vector<double>& other,
                       double factor, int decimals, const QString& unit)
{
  if (one.empty() || other.empty()) return QStringLiteral("–");
  const auto number = [&](double value) { return numberText(factor * value, decimals); };
  if (const auto welch = analysis::welchDifference(one, other)) {
    const analysis::Estimate& found = welch->difference;
    return withUnit(GroupsTable::tr("%1 (%2 to %3)")
                        .arg(number(found.value), number(found.low), number(found.high)),
                    unit);
  }
  return withUnit(number(analysis::statisticsOf(one).mean - analysis::statisticsOf(other).mean),
                  unit);
}

}  // namespace

QString groupText(const analysis::InsertionGroup& group,
                  const std::vector<analysis::GroupKey>& keys)
{
  QStringList parts;
  for (std::size_t i = 0; i < keys.size(); ++i) parts << valueText(group.values[i], keys[i]);
  return parts.join(QStringLiteral(" · "));
}

GroupsTable::GroupsTable(QWidget* parent) : QTableWidget(0, 0, parent)
{
  setObjectName(QStringLiteral("groupsTable"));
  setAccessibleName(tr("Groups"));
  setFont(typeface(13));
  showInRows(*this, sized(groupRow_px));
  setSelectionMode(QAbstractItemView::SingleSelection);
  setWordWrap(false);
  setIconSize({36, 12});
  horizontalHeader()->setFont(typeface(11));
  horizontalHeader()->setHighlightSections(false);
}

void GroupsTable::show(const std::vector<analysis::ComparedInsertion>& runs,
                       const std::vector<analysis::InsertionGroup>& groups,
                       const std::vector<analysis::GroupKey>& keys)
{
  clear();
  const auto& quantities = analysis::comparedQuantities();
  const int count = int(groups.size());
  setRowCount(int(quantities.size()) + 1);
  setColumnCount(1 + count + std::max(count - 1, 0));
  const auto setHeader = [this](int column, const QString& text, const QString& tip = {}) {
    auto* header = new QTableWidgetItem(text);
    header->setToolTip(tip);
    header->setTextAlignment(int(column == 0 ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter);
    setHorizontalHeaderItem(column, header);
  };
  setHeader(0, tr("Mean ± SD"));
  for (int i = 0; i < count; ++i) {
    const auto& group = groups[std::size_t(i)];
    setHeader(1 + i, tr("%1, n = %2").arg(groupText(group, keys)).arg(group.members.size()));
    horizontalHeaderItem(1 + i)->setIcon(QIcon(swatchOf(std::size_t(i))));
    if (i > 0)
      setHeader(
          count + i, tr("%1 − %2, 95 %").arg(groupText(groups[0], keys), groupText(group, keys)),
          tr("Difference of the means with its 95 % interval (Welch). Without an interval where "
             "a group has fewer than two insertions, or where none of them differ."));
  }
  for (int row = 0; row < rowCount(); ++row)
    for (int column = 0; column < columnCount(); ++column) {
      auto* item = new QTableWidgetItem;
      item->setTextAlignment(int(column == 0 ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter);
      setItem(row, column, item);
    }
  for (std::size_t i = 0; i < quantities.size(); ++i) {
    const analysis::ComparedQuantity& quantity = quantities[i];
    item(int(i) + 1, 0)->setText(dataText(Sentence(quantity.name)));
    std::vector<std::vector<double>> values;
    for (const analysis::InsertionGroup& group : groups)
      values.push_back(analysis::valuesOf(runs, group, quantity));
    fillRow(int(i) + 1, values, quantity.factor, quantity.decimals,
            QString::fromUtf8(quantity.unit));
  }
  horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
  setFixedHeight(horizontalHeader()->sizeHint().height() + rowCount() * sized(groupRow_px) +
                 2 * frameWidth() + 2);
}

void GroupsTable::fillRow(int row, const std::vector<std::vector<double>>& values, double factor,
                          int decimals, const QString& unit)
{
  const int count = int(values.size());
  for (int i = 0; i < count; ++i) {
    item(row, 1 + i)->setText(meanText(values[std::size_t(i)], factor, decimals, unit));
    if (i > 0)
      item(row, count + i)
          ->setText(differenceText(values[0], values[std::size_t(i)], factor, decimals, unit));
  }
}

void GroupsTable::showCursor(const std::vector<analysis::ComparedInsertion>& runs,
                             const std::vector<analysis::InsertionGroup>& groups,
                             analysis::CurveAxis axis, double shown)
{
  if (rowCount() == 0) return;
  std::vector<std::vector<double>> values;
  for (const analysis::InsertionGroup& group : groups) {
    auto& forces = values.emplace_back();
    for (const std::size_t member : group.members)
      if (const auto force =
              analysis::forceAt(analysis::curveOver(runs[member], axis), placeAt(axis, shown)))
        forces.push_back(*force);
  }
  item(0, 0)->setText(tr("insertion force at %1").arg(placeText(axis, shown)));
  fillRow(0, values, 1e3, 1, tr("mN"));
}

}  // namespace perilymph::gui
