// SPDX-License-Identifier: BSD-3-Clause
#include "gui/pages/compare/RunsTable.h"

#include <QDateTime>
#include <QHeaderView>
#include <QPainter>
#include <QPixmap>
#include <algorithm>

#include "gui/pages/compare/ComparisonPlot.h"
#include "gui/text/DataText.h"
#include "gui/text/Numbers.h"
#include "gui/widgets/TableRows.h"
#include "gui/widgets/Theme.h"
#include "perilymph/anatomy/Patient.h"
#include "perilymph/session/ScenarioChoices.h"

namespace perilymph::gui {

namespace {

enum Column {
  run,
  atCursor,
  peak,
  peakDepth,
  arrayPeak,
  work,
  speed,
  reversals,
  duration,
  angle,
  translocation,
  score,
  columns
};

constexpr int runRow_px = 44;  // two lines
constexpr int cursorWidth_px = 84;
constexpr int swatchWidth_px = 36;

/// "left", "right", or a dash for a recording that does not say.
QString sideText(const std::string& name)
{
  const auto side = valueIn(anatomy::sides, name);
  if (!side) return QStringLiteral("–");
  return *side == anatomy::Side::left ? RunsTable::tr("left") : RunsTable::tr("right");
}

/// "FLEX28 · standard", and below it patient, ear and time.
QString titleOf(const analysis::ComparedInsertion& insertion)
{
  const session::ScenarioSubject& subject = insertion.subject;
  const QString own = techniqueText(subject.technique);
  const QString technique =
      insertion.check.damage.empty() ? own : RunsTable::tr("%1 · changed by hand").arg(own);
  const auto utc = QDateTime::fromString(QString::fromStdString(insertion.startedUtc), Qt::ISODate);
  return RunsTable::tr("%1 · %2\n%3 · %4 ear · %5")
      .arg(QString::fromStdString(subject.array), technique,
           QString::fromStdString(subject.patient), sideText(subject.side),
           utc.toLocalTime().toString(QStringLiteral("yyyy-MM-dd HH:mm:ss")));
}

/// The titles; those that are equal with the name of their recording, which no other has.
QStringList titlesOf(const std::vector<analysis::ComparedInsertion>& runs)
{
  QStringList titles;
  for (const analysis::ComparedInsertion& each : runs) titles << titleOf(each);
  QStringList distinct;
  for (int i = 0; i < titles.size(); ++i)
    distinct << (titles.count(titles[i]) == 1
                     ? titles[i]
                     : RunsTable::tr("%1 · %2").arg(
                           titles[i], QString::fromStdString(runs[std::size_t(i)].name)));
  return distinct;
}

/// "3.2 mm" of the array in the scala vestibuli, "rupture at 210°" without it; a dash if the partition
/// held.
QString translocationText(const analysis::ComparedInsertion& each)
{
  if (!each.translocation) return RunsTable::tr("–");
  const double above_mm = inMillimeters(meters(each.translocation->lengthAbove));
  if (above_mm > 0.0) return RunsTable::tr("%1 mm").arg(numberText(above_mm, 1));
  return RunsTable::tr("rupture at %1°")
      .arg(numberText(inDegrees(radians(each.translocation->angle)), 0));
}

QString forceText(double force_N)
{
  return RunsTable::tr("%1 mN").arg(forceNumber(inMillinewtons(newtons(force_N))));
}

/// "200 mN at rib 1": the peak, and the rib at the opening that caused it.
QString peakText(const analysis::ComparedInsertion& each)
{
  const QString force = forceText(each.profile.peak.force);
  const bool isOfRib = each.ribPeak && each.ribPeak->force > each.arrayPeak.force;
  return isOfRib ? RunsTable::tr("%1 (rib %2)").arg(force).arg(each.ribNumber) : force;
}

}  // namespace

QString techniqueText(const std::string& name)
{
  return name == session::nameOf(session::Technique::advanceOffStylet)
             ? RunsTable::tr("advance off-stylet")
             : RunsTable::tr("standard");
}

QPixmap swatchOf(std::size_t number)
{
  constexpr int fineness = 2;
  QPixmap pixmap(fineness * swatchWidth_px, fineness * 12);
  pixmap.setDevicePixelRatio(fineness);
  pixmap.fill(Qt::transparent);
  QPainter painter(&pixmap);
  painter.setPen(penOfRun(number));
  painter.drawLine(QPointF(0, 6), QPointF(swatchWidth_px, 6));
  return pixmap;
}

RunsTable::RunsTable(QWidget* parent) : QTableWidget(0, columns, parent)
{
  setObjectName(QStringLiteral("comparisonTable"));
  setAccessibleName(tr("Results"));
  setFont(typeface(13));
  showInRows(*this, sized(runRow_px));
  setSelectionMode(QAbstractItemView::SingleSelection);
  setIconSize({swatchWidth_px, 12});
  setWordWrap(false);
  horizontalHeader()->setFont(typeface(11));
  horizontalHeader()->setHighlightSections(false);
  setHorizontalHeaderLabels({tr("Insertion"), tr("At cursor"), tr("Peak force"), tr("at depth"),
                             tr("Without ribs"), tr("Insertion work"), tr("Mean speed"),
                             tr("Reversals"), tr("Insertion time"), tr("Tip angle"),
                             tr("Translocation"), tr("Score")});
  horizontalHeaderItem(arrayPeak)->setToolTip(
      tr("Peak force with no marker rib at the opening: that of the array in the cochlea."));
  horizontalHeaderItem(speed)->setToolTip(
      tr("Inward motion up to the maximum depth by its time, pauses included."));
  for (int column = 0; column < columns; ++column) {
    horizontalHeader()->setSectionResizeMode(column, QHeaderView::ResizeToContents);
    horizontalHeaderItem(column)->setTextAlignment(
        int(column == run ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter);
  }
  // its texts change with the cursor
  horizontalHeader()->setSectionResizeMode(atCursor, QHeaderView::Fixed);
  horizontalHeader()->resizeSection(atCursor, sized(cursorWidth_px));
  horizontalHeader()->setSectionResizeMode(run, QHeaderView::Stretch);
}

void RunsTable::show(const std::vector<analysis::ComparedInsertion>& runs,
                     const std::vector<Result<analysis::InsertionScore>>& scores)
{
  setRowCount(int(runs.size()));
  const QStringList titles = titlesOf(runs);
  for (int row = 0; row < int(runs.size()); ++row) {
    const analysis::ComparedInsertion& each = runs[std::size_t(row)];
    const analysis::ForceProfile& profile = each.profile;
    const auto& scored = scores[std::size_t(row)];
    const std::pair<int, QString> cells[] = {
        {run, titles[row]},
        {peak, peakText(each)},
        {peakDepth, tr("%1 mm").arg(numberText(inMillimeters(meters(profile.peakDepth)), 1))},
        {arrayPeak, forceText(each.arrayPeak.force)},
        {work, tr("%1 mJ").arg(numberText(profile.work * 1e3, 2))},
        {speed, tr("%1 mm/s").arg(numberText(
                    inMillimetersPerSecond(metersPerSecond(each.motion.meanSpeed())), 2))},
        {reversals, QString::number(each.reversals)},
        {duration, tr("%1 s").arg(numberText(profile.duration, 1))},
        {angle, tr("%1°").arg(numberText(inDegrees(radians(profile.deepestAngle)), 0))},
        {translocation, translocationText(each)},
        {score, scored ? tr("%1 of 100").arg(numberText(scored->total, 0)) : tr("none")},
        {atCursor, QString()}};
    for (const auto& [column, caption] : cells) {
      auto* item = new QTableWidgetItem(caption);
      item->setTextAlignment(int(column == run ? Qt::AlignLeft : Qt::AlignRight) |
                             Qt::AlignVCenter);
      if (column == run) {
        item->setIcon(QIcon(swatchOf(std::size_t(row))));
        item->setToolTip(QString::fromStdString(each.name));
      }
      if (column == score)
        item->setToolTip(scored ? QString::fromStdString(scored->sentence())
                                : dataText(scored.error().message));
      setItem(row, column, item);
    }
  }
  const auto isTorn = [](const analysis::ComparedInsertion& each) {
    return each.translocation.has_value();
  };
  const auto hasRib = [](const analysis::ComparedInsertion& each) {
    return each.ribPeak.has_value();
  };
  setColumnHidden(translocation, std::ranges::none_of(runs, isTorn));
  setColumnHidden(arrayPeak, std::ranges::none_of(runs, hasRib));
  // height of its rows, up to five
  constexpr int maxRows = 5;
  const int rows = std::min(maxRows, std::max(1, int(runs.size())));
  setFixedHeight(horizontalHeader()->sizeHint().height() + rows * sized(runRow_px) +
                 2 * frameWidth() + 2);
  selectRow(0);
}

void RunsTable::showCursor(const std::vector<analysis::ComparedInsertion>& runs,
                           analysis::CurveAxis axis, double shown)
{
  const double place = placeAt(axis, shown);
  for (int row = 0; row < int(runs.size()) && row < rowCount(); ++row) {
    const auto force = analysis::forceAt(analysis::curveOver(runs[std::size_t(row)], axis), place);
    item(row, atCursor)
        ->setText(force ? tr("%1 mN").arg(numberText(inMillinewtons(newtons(*force)), 1))
                        : tr("–"));
  }
  horizontalHeaderItem(atCursor)->setText(tr("At %1").arg(placeText(axis, shown)));
}

}  // namespace perilymph::gui
