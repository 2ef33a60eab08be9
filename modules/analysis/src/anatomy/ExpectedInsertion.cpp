// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/analysis/ExpectedInsertion.h"

#include <algorithm>
#include <string>

namespace perilymph::analysis {

namespace {

constexpr double sectionStep_deg = 2.0;

/// The row at which a path along the lateral wall, inside it by a distance [m], reaches a length
/// [m]; the last one if it is shorter.
SectionRow rowAlongLateralWall(const std::vector<SectionRow>& rows, double length, double inside)
{
  double sum = 0.0;
  for (std::size_t i = 1; i < rows.size(); ++i) {
    // a parallel of a plane curve is shorter by the ratio of their radii
    const double radius = 0.5 * (rows[i - 1].section.outerRadius + rows[i].section.outerRadius);
    const double piece = std::max(0.0, radius - inside) / radius *
                         (rows[i].outerWallLength - rows[i - 1].outerWallLength);
    if (piece > 0.0 && sum + piece >= length) {
      const double fraction = (length - sum) / piece;
      SectionRow row = rows[i - 1];
      row.angle += fraction * (rows[i].angle - rows[i - 1].angle);
      row.organOfCortiLength +=
          fraction * (rows[i].organOfCortiLength - rows[i - 1].organOfCortiLength);
      return row;
    }
    sum += piece;
  }
  return rows.back();
}

bool isStraight(const electrode::ArrayDesign& array)
{
  return std::all_of(array.restCurvature.value.begin(), array.restCurvature.value.end(),
                     [](Curvature curvature) { return curvature.si() == 0.0; });
}

}  // namespace

Angle angleAlongLateralWall(const anatomy::ScalaTympani& scala, Length length, Length inside)
{
  const auto rows = sectionRows(scala, degrees(sectionStep_deg));
  return radians(rowAlongLateralWall(rows, length.si(), inside.si()).angle);
}

std::vector<Measure> expectedInsertion(const anatomy::ScalaTympani& scala,
                                       const electrode::ArrayDesign& array)
{
  if (!isStraight(array)) return {};
  const auto rows = sectionRows(scala, degrees(sectionStep_deg));
  const Length radius =
      0.25 * (array.sectionAt(Length{}).within + array.sectionAt(array.insertable).within);
  const Length deepest = array.insertable - array.contactsFromTip.front();
  const SectionRow end = rowAlongLateralWall(rows, deepest.si(), radius.si());
  const double organ = rows.back().organOfCortiLength;
  const Sentence source{"geometry of this model; real insertions end earlier"};
  return {
      {"angular_insertion_depth_deg", inDegrees(radians(end.angle)),
       Sentence{
           "angle of the most apical contact of an array that lies along the lateral wall in its "
           "whole length"},
       source},
      {"coverage_percent", organ > 0.0 ? 100.0 * end.organOfCortiLength / organ : 0.0,
       Sentence{"organ-of-Corti path up to that angle / whole path"}, source}};
}

}  // namespace perilymph::analysis
