// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/archive/MeasuredObjects.h"

#include "CtHeaders.h"
#include "perilymph/foundation/Version.h"

namespace perilymph::archive {

namespace {

ReportedMeasure reported(Quantity quantity, const ct::Measure& measure)
{
  const auto interval = measure.interval95();
  return {quantity, measure.value, 0.5 * (interval[1] - interval[0])};
}

}  // namespace

MeasurementReport reportOf(const ct::CochleaMeasures& measures)
{
  MeasurementReport report;
  report.measures = {reported(Quantity::a, measures.a), reported(Quantity::b, measures.b),
                     reported(Quantity::h, measures.h)};
  if (measures.cdlOc) report.measures.push_back(reported(Quantity::ductLength, *measures.cdlOc));
  report.isRight = measures.side == anatomy::Side::right;
  report.hasMarksByHand = !measures.marksByHand.isEmpty();
  report.software = buildId().substr(0, maxLetters);
  report.seriesKey = measures.provenance.seriesKey;
  return report;
}

Lumen lumenOf(const ct::CochleaMeasures& measures)
{
  Lumen lumen;
  for (const Eigen::Vector3d& point : measures.wall_P)
    lumen.points_mm.push_back({point.x(), point.y(), point.z()});
  lumen.pointsPerRing = measures.wallPointsPerRing;
  lumen.isRight = measures.side == anatomy::Side::right;
  lumen.hasMarksByHand = !measures.marksByHand.isEmpty();
  lumen.software = buildId().substr(0, maxLetters);
  lumen.seriesKey = measures.provenance.seriesKey;
  return lumen;
}

std::string pictureDescription(const ct::CochleaMeasures& measures)
{
  return std::string(measures.side == anatomy::Side::right ? "Right" : "Left") +
         " cochlea: cochlear view and the mid-modiolar planes along A and along B with the fitted "
         "wall, the lines of A, B and H, and a bar of 5 mm. A " +
         ct::millimetersOf(measures.a.value) + " mm, B " + ct::millimetersOf(measures.b.value) +
         " mm, H " + ct::millimetersOf(measures.h.value) + " mm.";
}

}  // namespace perilymph::archive
