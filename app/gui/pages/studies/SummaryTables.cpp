// SPDX-License-Identifier: BSD-3-Clause
#include "gui/pages/studies/SummaryTables.h"

#include <QHeaderView>
#include <QLabel>
#include <QScrollBar>
#include <QTableWidget>
#include <QVBoxLayout>
#include <QVariant>
#include <algorithm>
#include <array>
#include <cmath>

#include "gui/pages/studies/StudyText.h"
#include "gui/text/Numbers.h"
#include "gui/widgets/TableRows.h"
#include "gui/widgets/Theme.h"
#include "gui/widgets/WrappedLabel.h"

namespace perilymph::gui {

namespace {

constexpr int row_px = 22;
constexpr int narrowest_px = 64;
constexpr int maxRows = 4;  // more are scrolled: the plot needs the space
/// Decimals of the first of study::summarizedQuantities: angle, depth and peak force, which has those of
/// every force. The export has all.
using Decimals = std::array<int, 3>;
Decimals decimalsOf(const study::StudySummary& summary, study::StudySelection selection)
{
  double largest_mN = 0.0;
  for (const study::StudyGroup& group : summary.groups)
    if (const auto& peak = group.samples[selection].quartiles[2])
      largest_mN = std::max(largest_mN, peak->high);
  return {0, 1, forceDecimals(largest_mN)};
}

const QString none = QStringLiteral("–");

QTableWidget* tableOf(const char* name, const QString& title, QWidget* parent)
{
  auto* table = new QTableWidget(0, 0, parent);
  table->setObjectName(QLatin1String(name));
  table->setAccessibleName(title);
  table->setFont(typeface(12));
  showInRows(*table, sized(row_px));
  table->setSelectionMode(QAbstractItemView::SingleSelection);
  table->setWordWrap(false);
  table->horizontalHeader()->setMinimumSectionSize(sized(narrowest_px));
  table->horizontalHeader()->setFont(typeface(11));
  table->horizontalHeader()->setHighlightSections(false);
  return table;
}

/// Fills a table with texts; the first column is wider and at the left.
void fill(QTableWidget& table, const QStringList& heads, const std::vector<QStringList>& rows)
{
  table.clear();
  table.setColumnCount(int(heads.size()));
  table.setRowCount(int(rows.size()));
  const auto alignment = [](int column) {
    return int(column == 0 ? Qt::AlignLeft : Qt::AlignRight) | int(Qt::AlignVCenter);
  };
  for (int column = 0; column < heads.size(); ++column) {
    auto* head = new QTableWidgetItem(heads[column]);
    head->setTextAlignment(alignment(column));
    head->setToolTip(heads[column]);
    table.setHorizontalHeaderItem(column, head);
  }
  for (std::size_t row = 0; row < rows.size(); ++row)
    for (int column = 0; column < heads.size(); ++column) {
      auto* item = new QTableWidgetItem(rows[row][column]);
      item->setTextAlignment(alignment(column));
      item->setToolTip(rows[row][column]);
      table.setItem(int(row), column, item);
    }
  table.horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  const int shown = std::min(int(rows.size()), maxRows);
  // no name is cut: what is wider than the table is scrolled
  const bool isWide = table.horizontalHeader()->length() > table.width() - 2 * table.frameWidth();
  if (!isWide) table.horizontalHeader()->setSectionResizeMode(0, QHeaderView::Stretch);
  const int bar = isWide ? table.horizontalScrollBar()->sizeHint().height() : 0;
  table.setFixedHeight(table.horizontalHeader()->sizeHint().height() + shown * sized(row_px) + bar +
                       2 * table.frameWidth() + 2);
}

/// "554 (542 to 566)"
QString rangeText(const std::optional<analysis::Estimate>& found, int places)
{
  if (!found) return none;
  return SummaryTables::tr("%1 (%2 to %3)")
      .arg(numberText(found->value, places), numberText(found->low, places),
           numberText(found->high, places));
}

/// "554 (542–566); 553": median, quartiles and mean of values that are not negative.
QString sampleText(const study::StudySample& sample, std::size_t quantity, int decimals)
{
  const auto& found = sample.quartiles[quantity];
  if (!found) return none;
  const auto number = [&](double value) { return numberText(value, decimals); };
  return SummaryTables::tr("%1 (%2–%3); %4")
      .arg(number(found->value), number(found->low), number(found->high),
           number(sample.means[quantity]->mean));
}

/// Decimals that give a value two digits or more.
int placesOf(double value)
{
  const double size = std::fabs(value);
  return size > 0.0 ? std::clamp(1 - int(std::floor(std::log10(size))), 0, 4) : 0;
}

QString percent(double value) { return numberText(100.0 * value, 0); }

/// "19 % (11–30)"; of few insertions "3 of 16 (7–43 %)".
QString completeText(const study::StudyGroup& group)
{
  if (const auto count = analysis::countedOf(group.rate, group.rows.size()))
    return SummaryTables::tr("%1 of %2 (%3–%4 %)")
        .arg(*count)
        .arg(group.rows.size())
        .arg(percent(group.rate.low), percent(group.rate.high));
  return SummaryTables::tr("%1 % (%2–%3)")
      .arg(percent(group.rate.value), percent(group.rate.low), percent(group.rate.high));
}

/// "1"; "1, 2 not prepared".
QString stoppedText(const study::StudyGroup& group)
{
  const QString stopped = QString::number(group.stopped());
  return group.notPrepared() == 0
             ? stopped
             : SummaryTables::tr("%1, %2 not prepared").arg(stopped).arg(group.notPrepared());
}

QString nameOf(const study::StudySummary& summary, const study::StudyGroup& group)
{
  return group.level.empty() ? SummaryTables::tr("All insertions")
                             : inTheList(valueText(summary.axes.group, group.level));
}

}  // namespace

SummaryTables::SummaryTables(QWidget* parent)
    : QWidget(parent),
      groups_(tableOf("studyGroups", tr("Groups of insertions"), this)),
      differences_(tableOf("studyDifferences", tr("Differences of groups"), this)),
      method_(new WrappedLabel({}, this))
{
  method_->setFont(typeface(11));
  method_->setProperty("quiet", true);
  setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Maximum);  // the plot takes the height
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(spacing / 2);
  column->addWidget(groups_);
  column->addWidget(differences_);
  column->addWidget(method_);
}

void SummaryTables::show(const study::StudySummary& summary, study::StudySelection selection)
{
  showGroups(summary, selection);
  showDifferences(summary, selection);
  const QString of =
      selection == study::StudySelection::ran
          ? tr("Median (quartiles); mean. They, differences and lines are of all "
               "insertions that ran, the stopped ones with what they reached.")
          : tr("Median (quartiles); mean. They, differences and lines are of complete "
               "insertions only: without the stopped ones they look deeper and "
               "gentler.");
  method_->setText(
      of + QLatin1Char(' ') +
      tr("Intervals of 95 %: Wilson for complete insertions; in it and in those of the lines "
         "insertions that share a cochlea count as independent; of differences of means, Student "
         "over "
         "cochleae of pairs that share the draw, Welch for groups without pairs; not corrected for "
         "several comparisons. Lines: least squares, with the 95 % band of the mean."));
}

void SummaryTables::showGroups(const study::StudySummary& summary, study::StudySelection selection)
{
  const Decimals decimals = decimalsOf(summary, selection);
  std::vector<QStringList> rows;
  for (const study::StudyGroup& group : summary.groups) {
    QStringList row{nameOf(summary, group), completeText(group), stoppedText(group)};
    const study::StudySample& sample = group.samples[selection];
    for (std::size_t i = 0; i < decimals.size(); ++i) row << sampleText(sample, i, decimals[i]);
    row << (sample.trend ? rangeText(sample.trend->slope(), placesOf(sample.trend->slope().value))
                         : none);
    rows.push_back(row);
  }
  const QString x = unitOf(summary.axes.x), y = unitOf(summary.axes.y);
  const QString slope = x.isEmpty() || y.isEmpty() ? tr("Slope") : tr("Slope, %1/%2").arg(y, x);
  fill(*groups_,
       {tr("Group"), tr("Complete (95 %)"), tr("Stopped"), tr("Angle, °"), tr("Depth, mm"),
        tr("Peak force, mN"), slope},
       rows);
  for (int row = 0; row < int(summary.groups.size()); ++row) {
    const study::StudyGroup& group = summary.groups[std::size_t(row)];
    groups_->item(row, 1)->setToolTip(
        tr("%1 of %2 complete: %3 % (%4–%5)")
            .arg(group.complete())
            .arg(group.rows.size())
            .arg(percent(group.rate.value), percent(group.rate.low), percent(group.rate.high)));
  }
}

void SummaryTables::showDifferences(const study::StudySummary& summary,
                                    study::StudySelection selection)
{
  const Decimals decimals = decimalsOf(summary, selection);
  std::vector<QStringList> rows;
  for (const study::StudyDifference& each : summary.differences) {
    if (each.selection != selection) continue;
    QStringList row{tr("%1 − %2").arg(nameOf(summary, summary.groups[each.group]),
                                      nameOf(summary, summary.groups[each.other])),
                    each.isPaired ? tr("%1 pairs, %2 cochleae").arg(each.count).arg(each.cochleae)
                                  : tr("Welch, %1 and %2").arg(each.count).arg(each.otherCount)};
    for (std::size_t i = 0; i < decimals.size(); ++i) row << rangeText(each.means[i], decimals[i]);
    rows.push_back(row);
  }
  differences_->setVisible(!rows.empty());
  fill(*differences_,
       {tr("Difference of means (95 %)"), tr("Of"), tr("Angle, °"), tr("Depth, mm"),
        tr("Peak force, mN")},
       rows);
}

}  // namespace perilymph::gui
