// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/ct/Marks.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <string>

#include "perilymph/ct/Measures.h"

namespace perilymph::ct {

namespace {

constexpr std::array<const char*, markCount> names{"RW", "OW", "B1", "B2", "H", "A", "C"};
// Read as well; the window shows them.
constexpr std::array<const char*, markCount> clinicalNames{"RW",   "LW",   "B1", "B2",
                                                           "base", "apex", "M"};
constexpr std::size_t basalRings = 90;  // of 4 degrees each

/// The outermost point of the basal turn's wall in a direction across the axis.
Eigen::Vector3d outermost_P(const CochleaMeasures& measures, const Eigen::Vector3d& direction_P)
{
  const std::size_t end = std::min(measures.wall_P.size(), basalRings * measures.wallPointsPerRing);
  const Eigen::Vector3d side_P = measures.axis_P.cross(direction_P);
  Eigen::Vector3d best = measures.center_P;
  double farthest = 0.0;
  for (std::size_t k = 0; k < end; ++k) {
    const Eigen::Vector3d from = measures.wall_P[k] - measures.center_P;
    const double along = direction_P.dot(from), aside = std::fabs(side_P.dot(from));
    // rings are 4 degrees apart: half that to either side, 0.035 rad, catches at least one
    if (along <= farthest || aside > 0.04 * along) continue;
    farthest = along;
    best = measures.wall_P[k];
  }
  return best;
}

std::optional<double> across(const std::optional<Eigen::Vector3d>& one,
                             const std::optional<Eigen::Vector3d>& other,
                             const std::optional<Eigen::Vector3d>& axis_P)
{
  if (!one || !other) return std::nullopt;
  const Eigen::Vector3d between = *other - *one;
  if (!axis_P) return between.norm();
  return (between - axis_P->dot(between) * *axis_P).norm();
}

}  // namespace

const char* nameOf(Mark mark) { return names[static_cast<std::size_t>(mark)]; }

std::optional<Mark> markNamed(const std::string& name)
{
  for (const auto& each : {names, clinicalNames})
    if (const auto found = std::ranges::find(each, name); found != each.end())
      return static_cast<Mark>(found - each.begin());
  return std::nullopt;
}

bool Marks::isEmpty() const
{
  return std::ranges::none_of(points_P, [](const auto& point) { return point.has_value(); });
}

bool Marks::operator==(const Marks& other) const
{
  return std::ranges::equal(points_P, other.points_P, [](const auto& one, const auto& two) {
    return one.has_value() == two.has_value() && (!one || *one == *two);
  });
}

std::optional<Eigen::Vector3d> Marks::inside_P() const
{
  const auto& center = (*this)[Mark::modiolus];
  const auto& top = (*this)[Mark::apex];
  const auto& window = (*this)[Mark::roundWindow];
  const auto& far = (*this)[Mark::farWall];
  // the modiolus, a third of the way up, lies amid the turns
  if (center && top) return 0.7 * *center + 0.3 * *top;
  if (center) return center;
  if (window && far) return 0.5 * (*window + *far);
  if (window && top) return 0.5 * (*window + *top);
  return top ? top : window;
}

Marks marksOf(const CochleaMeasures& measures)
{
  const Eigen::Vector3d x = measures.axes_PW.col(0), y = measures.axes_PW.col(1);
  Marks marks;
  marks[Mark::roundWindow] = measures.roundWindow_P;
  const Eigen::Vector3d far = outermost_P(measures, -x);
  marks[Mark::nearB] = outermost_P(measures, y);
  marks[Mark::farB] = outermost_P(measures, -y);
  marks[Mark::farWall] = far;
  marks[Mark::modiolus] = measures.center_P;
  double low = 0.0, high = 0.0;
  bool isFirst = true;
  for (const Eigen::Vector3d& point : measures.wall_P) {
    const double height = measures.axis_P.dot(point - measures.center_P);
    low = isFirst ? height : std::min(low, height);
    high = isFirst ? height : std::max(high, height);
    isFirst = false;
  }
  // H as measured begins at the lowest floor after 20 degrees and ends at the highest roof
  marks[Mark::apex] = measures.center_P + high * measures.axis_P;
  marks[Mark::floor] = measures.center_P + (high - measures.h.value) * measures.axis_P;
  return marks;
}

MarkedMeasures measuresBetween(const Marks& marks, const std::optional<Eigen::Vector3d>& axis_P)
{
  std::optional<Eigen::Vector3d> axis = axis_P;
  const auto &center = marks[Mark::modiolus], &top = marks[Mark::apex], &floor = marks[Mark::floor];
  if (!axis && center && top && (*top - *center).norm() > 1.0) axis = (*top - *center).normalized();
  MarkedMeasures measures;
  measures.a = across(marks[Mark::roundWindow], marks[Mark::farWall], axis);
  measures.b = across(marks[Mark::nearB], marks[Mark::farB], axis);
  if (floor && top)
    measures.h = axis ? std::fabs(axis->dot(*top - *floor)) : (*top - *floor).norm();
  return measures;
}

std::vector<Sentence> landmarkContradictions(const CochleaMeasures& measures)
{
  Marks marks = marksOf(measures);
  for (std::size_t k = 0; k < markCount; ++k)
    if (const auto& placed = measures.marksByHand.points_P[k]) marks.points_P[k] = placed;
  const MarkedMeasures between = measuresBetween(marks, measures.axis_P);
  const std::array marked{between.a, between.b, between.h};
  const std::array measured{&measures.a, &measures.b, &measures.h};
  std::vector<Sentence> sentences;
  for (std::size_t k = 0; k < measureLines.size(); ++k) {
    const MeasureLine& line = measureLines[k];
    if (!measures.marksByHand[line.from] && !measures.marksByHand[line.to]) continue;
    const auto [low, high] = measured[k]->interval95();
    if (!marked[k] || (*marked[k] >= low && *marked[k] <= high)) continue;
    sentences.push_back(Sentence{
        "%1 between the landmarks is %2 mm, outside the 95 % interval of the fitted one, %3 "
        "to %4 mm. The fitted one is used: check the landmarks in the images.",
        line.name, millimetersOf(*marked[k]), millimetersOf(low), millimetersOf(high)});
  }
  return sentences;
}

}  // namespace perilymph::ct
