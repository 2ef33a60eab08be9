// SPDX-License-Identifier: BSD-3-Clause
#include "gui/pages/plan/PlanText.h"

#include <QCoreApplication>
#include <algorithm>

#include "gui/pages/plan/CoverageReference.h"
#include "gui/setup/PlannedFriction.h"
#include "gui/text/DataText.h"
#include "gui/text/Numbers.h"
#include "perilymph/foundation/Normal.h"

namespace perilymph::gui {

namespace {

// lupdate assigns texts of free functions to their namespace.
QString tr(const char* text) { return QCoreApplication::translate("perilymph::gui", text); }

/// Small forces on the partition have a decimal, as in the report.
int decimalsOf(const planning::Band& band, PlanColumn column)
{
  return column == PlanColumn::partition ? forceDecimals(band.high) : 0;
}

QString coverageMethod()
{
  const QString method =
      tr("Fraction of the organ of Corti that is basal to the most apical contact.");
  const auto reference = coverageReference();
  if (!reference) return method + QLatin1Char(' ') + dataText(reference.error().message);
  return method + QLatin1Char('\n') +
         tr("Outlined: %1 to %2 %, for orientation; studies differ. %3")
             .arg(numberText(reference->low_percent, 0), numberText(reference->high_percent, 0),
                  dataText(reference->source));
}

}  // namespace

PlanCellKind kindOf(PlanColumn column)
{
  switch (column) {
    case PlanColumn::array:
      return PlanCellKind::name;
    case PlanColumn::force:
      return PlanCellKind::curve;
    case PlanColumn::complete:
    case PlanColumn::resisted:
    case PlanColumn::buckled:
    case PlanColumn::foldedTip:
    case PlanColumn::ruptured:
      return PlanCellKind::probability;
    default:
      return PlanCellKind::band;
  }
}

QString titleOf(PlanColumn column)
{
  switch (column) {
    case PlanColumn::array:
      return tr("Array");
    case PlanColumn::angle:
      return tr("Angular insertion depth");
    case PlanColumn::coverage:
      return tr("Cochlear coverage");
    case PlanColumn::peak:
      return tr("Peak force");
    case PlanColumn::end:
      return tr("End force");
    case PlanColumn::force:
      return tr("Force over depth");
    case PlanColumn::partition:
      return tr("Force on the partition");
    case PlanColumn::complete:
      return tr("All contacts inside");
    case PlanColumn::resisted:
      return tr("Stopped by resistance");
    case PlanColumn::buckled:
      return tr("Buckling");
    case PlanColumn::foldedTip:
      return tr("Tip fold-over");
    case PlanColumn::ruptured:
      return tr("Partition rupture");
  }
  return {};
}

QString methodOf(PlanColumn column)
{
  switch (column) {
    case PlanColumn::array:
      return tr(
          "Every array is inserted in the same drawn cochleae by the same drawn surgeons. "
          "Models follow published data; they are not manufacturer data.");
    case PlanColumn::angle:
      return tr(
          "Angle of the most apical contact from the round window at the end of each "
          "insertion. Median and the band that the head names.");
    case PlanColumn::coverage:
      return coverageMethod();
    case PlanColumn::peak:
      return tr(
          "Maximum axial force on the surgeon’s hand. Median and the band that the head names.");
    case PlanColumn::end:
      return tr(
          "Axial force on the hand at its stop, by the line through the last half second of "
          "motion. "
          "Median and the band that the head names.");
    case PlanColumn::force:
      return tr(
          "Axial force over the depth of the tip past the opening, as deep as any simulation went. "
          "Line: median; area: the band that the head names; paler and dashed where some "
          "simulations have ended. All "
          "rows have the same axes.");
    case PlanColumn::partition:
      return tr(
          "Maximum force on the cochlear partition. Median and the band that the head names.");
    case PlanColumn::complete:
      return tr(
          "Fraction of the insertions that end with all contacts inside the cochlea, which clinics "
          "count as complete, with its 95 % interval (Wilson 1927).");
    case PlanColumn::resisted:
      return tr(
          "Fraction in which the force reaches the limit at which the drawn surgeon stops, "
          "with its 95 % interval (Wilson 1927).");
    case PlanColumn::buckled:
      return tr(
          "Fraction in which the array bows in front of the opening, with its 95 % interval "
          "(Wilson 1927).");
    case PlanColumn::foldedTip:
      return tr("Fraction in which the tip folds over, with its 95 % interval (Wilson 1927).");
    case PlanColumn::ruptured:
      return tr(
          "Fraction in which the force on the cochlear partition reaches its drawn strength, "
          "with its 95 % interval (Wilson 1927). The strength rests on few publications.");
  }
  return {};
}

const planning::Band& bandOf(const planning::ArrayPlan& plan, PlanColumn column)
{
  switch (column) {
    case PlanColumn::coverage:
      return plan.coverage_percent;
    case PlanColumn::peak:
      return plan.peak_mN;
    case PlanColumn::end:
      return plan.end_mN;
    case PlanColumn::partition:
      return plan.partition_mN;
    default:
      return plan.angle_deg;
  }
}

const analysis::Estimate& estimateOf(const planning::ArrayPlan& plan, PlanColumn column)
{
  switch (column) {
    case PlanColumn::resisted:
      return plan.resisted;
    case PlanColumn::buckled:
      return plan.buckled;
    case PlanColumn::foldedTip:
      return plan.foldedTip;
    case PlanColumn::ruptured:
      return plan.ruptured;
    default:
      return plan.allInside;
  }
}

QString medianText(const planning::Band& band, PlanColumn column)
{
  const QString median = numberText(band.median, decimalsOf(band, column));
  if (column == PlanColumn::angle) return tr("%1°").arg(median);
  if (column == PlanColumn::coverage) return tr("%1 %").arg(median);
  return tr("%1 mN").arg(median);
}

QString rangeText(const planning::Band& band, PlanColumn column)
{
  const int decimals = decimalsOf(band, column);
  const QString low = numberText(band.low, decimals), high = numberText(band.high, decimals);
  if (column == PlanColumn::angle) return tr("%1–%2°").arg(low, high);
  if (column == PlanColumn::coverage) return tr("%1–%2 %").arg(low, high);
  return tr("%1–%2 mN").arg(low, high);
}

QString bandText(const planning::Band& band, PlanColumn column)
{
  const int decimals = decimalsOf(band, column);
  const QString median = numberText(band.median, decimals), low = numberText(band.low, decimals),
                high = numberText(band.high, decimals);
  if (column == PlanColumn::angle) return tr("%1 (%2–%3)°").arg(median, low, high);
  if (column == PlanColumn::coverage) return tr("%1 (%2–%3) %").arg(median, low, high);
  return tr("%1 (%2–%3) mN").arg(median, low, high);
}

std::optional<analysis::ReportedQuantity> reportedOf(PlanColumn column)
{
  using analysis::ReportedQuantity;
  switch (column) {
    case PlanColumn::angle:
      return ReportedQuantity::angle;
    case PlanColumn::peak:
      return ReportedQuantity::peakForce;
    case PlanColumn::end:
      return ReportedQuantity::endForce;
    case PlanColumn::complete:
      return ReportedQuantity::complete;
    case PlanColumn::foldedTip:
      return ReportedQuantity::foldOver;
    case PlanColumn::ruptured:
      return ReportedQuantity::translocation;
    default:
      return std::nullopt;
  }
}

QString intervalText(const analysis::Estimate& estimate, std::size_t draws)
{
  if (analysis::countedOf(estimate, draws)) return {};
  return tr("%1–%2 %").arg(numberText(100.0 * estimate.low, 0),
                           numberText(100.0 * estimate.high, 0));
}

QString factsOf(const planning::ArrayPlan& array, const planning::Plan& plan)
{
  const planning::Thresholds& thresholds = plan.thresholds;
  const auto newton = [](Force force) { return numberText(inMillinewtons(force), 0); };
  const planning::Band& felt = array.firstResistance_mm;
  QStringList facts{
      tr("Depth of the tip: %1 (%2–%3) mm.")
          .arg(numberText(array.depth_mm.median, 1), numberText(array.depth_mm.low, 1),
               numberText(array.depth_mm.high, 1)),
      tr("First resistance that surgeons feel (%1 mN): at %2 (%3–%4) mm, in %5 of the insertions.")
          .arg(newton(thresholds.felt), numberText(felt.median, 1), numberText(felt.low, 1),
               numberText(felt.high, 1), shownShare(array.felt, array.draws)),
      tr("Force on the partition reaches %1 mN, the lowest strength that is assumed, in %2, and "
         "%3 mN, the highest, in %4.")
          .arg(newton(thresholds.ruptureLow), shownShare(array.reachesWeakest, array.draws),
               newton(thresholds.ruptureHigh), shownShare(array.reachesStrongest, array.draws))};
  const planning::Band &soon = array.after1s_mN, &late = array.after10s_mN;
  if (soon.high != 0.0 && late.high != 0.0)  // of a version that computed them
    facts << tr("Force at rest: %1 (%2–%3) mN after 1 s, %4 (%5–%6) mN after 10 s.")
                 .arg(numberText(soon.median, 0), numberText(soon.low, 0), numberText(soon.high, 0),
                      numberText(late.median, 0), numberText(late.low, 0),
                      numberText(late.high, 0));
  if (const auto& found = array.atMedianFriction)
    facts.prepend(tr("At the median friction, %1, only: %2, peak force %3.")
                      .arg(numberText(plan.friction.low, 3),
                           bandText(found->angle_deg, PlanColumn::angle),
                           bandText(found->peak_mN, PlanColumn::peak)));
  return facts.join(QLatin1Char(' '));
}

QString differencesOf(const planning::Plan& plan, const std::vector<std::size_t>& arrays)
{
  const auto isShown = [&arrays](std::size_t array) {
    return std::ranges::find(arrays, array) != arrays.end();
  };
  QStringList lines;
  for (const planning::ArrayDifference& each : plan.differences)
    if (isShown(each.first) && isShown(each.second))
      lines << tr("%1 against %2: %3°, deeper in %4; peak force %5 mN, higher in %6.")
                   .arg(QString::fromStdString(plan.arrays[each.first].name),
                        QString::fromStdString(plan.arrays[each.second].name),
                        differenceText(each.angle_deg), shownShare(each.deeper, each.draws),
                        differenceText(each.peak_mN), shownShare(each.harder, each.draws));
  if (!lines.isEmpty())
    lines.prepend(tr("Differences in the same ear, with the same hand and friction (%1):")
                      .arg(bandsShare(plan)));
  return lines.join(QLatin1Char('\n'));
}

QString shapeTitle(const planning::ArrayPlan& array, const planning::PlannedInsertion& insertion)
{
  return tr("%1 · simulation %2, closest to the medians: %3°, peak %4 mN")
      .arg(QString::fromStdString(array.name))
      .arg(insertion.draw)
      .arg(numberText(inDegrees(insertion.insertion.apical), 0),
           numberText(inMillinewtons(insertion.insertion.peak), 0));
}

QString measureText(Length value, Length standardDeviation)
{
  return tr("%1 ± %2 mm")
      .arg(numberText(inMillimeters(value), 2),
           numberText(halfWidth95 * inMillimeters(standardDeviation), 2));
}

}  // namespace perilymph::gui
