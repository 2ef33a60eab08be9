// SPDX-License-Identifier: BSD-3-Clause
#include "RoundWindow.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "perilymph/foundation/Math.h"
#include "perilymph/foundation/Units.h"

namespace perilymph::ct {
namespace {

// The map has a resolution of a degree by 0.05 mm.
constexpr int columns = 136, rows = 80;
constexpr double firstAngle_deg = -62.0, lowest_mm = -1.6, rowStep_mm = 0.05;
constexpr double degree_mm = 0.1;  // along the wall, at a radius of 5.7 mm
constexpr double beyond_mm = 1.0;  // search range of bone behind the fitted wall

// In ten real ears the marked round window is about here in W (6.8 degrees, spread 8).
constexpr double usual_deg = 5.0, usualSpread_deg = 10.0;
// Where none is found there, it is looked for farther along the wall: the fit may have slid along the
// spiral. Of 450 phantoms it had by 20 to 50 degrees in 2 %.
constexpr double wideSpread_deg = 20.0;
// Errors of an opening far from the usual position, and of the usual position where there is none at
// all: in those phantoms up to 35 and 48 degrees (chosen with their results in view).
constexpr double wideError_deg = 15.0, lostSpread_deg = 25.0;
constexpr double usualDepth_mm = 0.9, usualDepthSpread_mm = 0.5;  // below the section's center
// Seen from the axis, the niche's opening is ahead of the marked center: by 2.2 to 2.9 degrees in
// leave-one-out on ten real ears, with a spread of 2.1.
constexpr double niche_deg = 2.5;
constexpr double foundSpread_deg = 2.5;
// The membrane's center is behind the plane of the bony rim: by 0.11 mm on phantoms, and by 0.18 on
// ten real ears (but -0.03 on the four with fluid); the smallest value consistent with both is
// used.
constexpr double recess_mm = 0.05;

/// Distance from the axis at which bone begins, for every angle and height; NaN if there is none.
using BoneMap = std::vector<double>;

double angleOf(double column) { return degrees(firstAngle_deg + column).si(); }
double heightOf(double row) { return lowest_mm + rowStep_mm * row; }

BoneMap mapOf(const CtVolume& volume, const ShapedLumen& lumen, const FitState& state)
{
  BoneMap map(columns * rows, std::numeric_limits<double>::quiet_NaN());
  const double middle = 0.5 * (state.bone + state.lumen);
  const double sign = state.bone > state.lumen ? 1.0 : -1.0;
  for (int column = 0; column < columns; ++column) {
    const double angle = std::max(MeanLumen::firstAngle(), angleOf(column));
    const SineCosine turn = sineCosine(angleOf(column));
    const SectionPlace place = lumen.place(angle);
    for (int row = 0; row < rows; ++row) {
      double before = place.outer - 0.4 * lumen.mean().width(angle);
      double valueBefore = 0.0;
      constexpr double step = 0.06;
      for (double r = before; r < place.outer + beyond_mm; r += step) {
        const auto value =
            volume.sample(state.pose.outOf_W({r * turn.cosine, r * turn.sine, heightOf(row)}));
        if (!value) break;
        if ((*value - middle) * sign > 0.0) {
          const double change = *value - valueBefore;
          const double fraction =
              r > before && change != 0.0 ? (middle - valueBefore) / change : 1.0;
          map[static_cast<std::size_t>(row * columns + column)] = before + fraction * (r - before);
          break;
        }
        before = r;
        valueBefore = *value;
      }
    }
  }
  return map;
}

/// A connected component of pixels without bone.
struct Opening {
  std::vector<int> pixels;
  double column = 0.0, row = 0.0;  ///< Its center.
  bool isCut = false;              ///< It reaches the map's edge.
};

Opening grow(const BoneMap& map, int seed, std::vector<bool>& isTaken)
{
  Opening opening;
  opening.pixels.push_back(seed);
  isTaken[static_cast<std::size_t>(seed)] = true;
  for (std::size_t next = 0; next < opening.pixels.size(); ++next) {
    const int column = opening.pixels[next] % columns, row = opening.pixels[next] / columns;
    opening.column += column;
    opening.row += row;
    const std::array<std::array<int, 2>, 4> neighbors{
        {{column - 1, row}, {column + 1, row}, {column, row - 1}, {column, row + 1}}};
    for (const auto& [c, r] : neighbors) {
      if (c < 0 || r < 0 || c >= columns || r >= rows) {
        opening.isCut = true;
        continue;
      }
      const auto at = static_cast<std::size_t>(r * columns + c);
      if (isTaken[at] || !std::isnan(map[at])) continue;
      isTaken[at] = true;
      opening.pixels.push_back(r * columns + c);
    }
  }
  opening.column /= static_cast<double>(opening.pixels.size());
  opening.row /= static_cast<double>(opening.pixels.size());
  return opening;
}

/// The opening most likely to be the window: of a window's size and near its usual position, within
/// a spread along the wall. Empty if there is none.
Opening likeliestOpening(const BoneMap& map, double usualHeight_mm, double spread_deg)
{
  constexpr double minArea_mm2 = 0.15, maxArea_mm2 = 5.0, maxCost = 12.0, cutCost = 4.0;
  Opening best;
  double minimum = maxCost;
  std::vector<bool> isTaken(map.size());
  for (int i = 0; i < columns * rows; ++i) {
    if (isTaken[static_cast<std::size_t>(i)] || !std::isnan(map[static_cast<std::size_t>(i)]))
      continue;
    Opening opening = grow(map, i, isTaken);
    const double area_mm2 = degree_mm * rowStep_mm * static_cast<double>(opening.pixels.size());
    if (area_mm2 < minArea_mm2 || area_mm2 > maxArea_mm2) continue;
    const double along = (firstAngle_deg + opening.column - usual_deg - niche_deg) / spread_deg;
    const double up = (heightOf(opening.row) - usualHeight_mm) / usualDepthSpread_mm;
    const double cost = along * along + up * up + (opening.isCut ? cutCost : 0.0);
    if (cost < minimum) {
      minimum = cost;
      best = std::move(opening);
    }
  }
  return best;
}

/// Radius of the wall at a point of the map: a plane fitted to the bone around the opening.
double radiusAcross(const BoneMap& map, const Opening& opening, double column, double row)
{
  Eigen::Matrix3d left = Eigen::Matrix3d::Identity() * 1e-6;
  Eigen::Vector3d right = Eigen::Vector3d::Zero();
  for (int i = 0; i < columns * rows; ++i) {
    const double radius = map[static_cast<std::size_t>(i)];
    if (std::isnan(radius)) continue;
    double minimum = 1e9;
    for (const int hole : opening.pixels) {
      const double along = degree_mm * (i % columns - hole % columns);
      const double up = rowStep_mm * (i / columns - hole / columns);
      minimum = std::min(minimum, along * along + up * up);
    }
    // Near the hole the niche rounds the edge; far from it the wall differs.
    if (minimum < 0.14 * 0.14 || minimum > 0.4 * 0.4) continue;
    const Eigen::Vector3d term(1.0, degree_mm * (i % columns - column),
                               rowStep_mm * (i / columns - row));
    left += term * term.transpose();
    right += radius * term;
  }
  return left.ldlt().solve(right)[0];
}

}  // namespace

RoundWindow findRoundWindow(const CtVolume& volume, const ShapedLumen& lumen, const FitState& state)
{
  const BoneMap map = mapOf(volume, lumen, state);
  const double usualHeight_mm = lumen.place(degrees(usual_deg).si()).middle - usualDepth_mm;
  Opening opening = likeliestOpening(map, usualHeight_mm, usualSpread_deg);
  const bool isUsual = !opening.pixels.empty();
  if (!isUsual) opening = likeliestOpening(map, usualHeight_mm, wideSpread_deg);
  RoundWindow window;
  double column = usual_deg - firstAngle_deg;
  double row = (usualHeight_mm - lowest_mm) / rowStep_mm;
  double radius = lumen.place(degrees(usual_deg).si()).outer;
  window.angleError = degrees(lostSpread_deg).si();
  if (!opening.pixels.empty()) {
    column = opening.column - niche_deg;
    row = opening.row;
    const double across = radiusAcross(map, opening, column, row);
    const double byShape = lumen.place(angleOf(column)).outer;
    // A rim far from the fitted wall is a different structure: the wall itself is the better
    // estimate.
    radius = (std::fabs(across - byShape) < 0.8 ? across : byShape) - recess_mm;
    window.isFound = isUsual;
    window.angleError = degrees(isUsual ? foundSpread_deg : wideError_deg).si();
  }
  window.angle = angleOf(column);
  const SineCosine turn = sineCosine(window.angle);
  window.center_W = {radius * turn.cosine, radius * turn.sine, heightOf(row)};
  return window;
}

RoundWindow withClick(const RoundWindow& window, const Eigen::Vector3d& click_W)
{
  const double angle = arcTangent(click_W.y(), click_W.x());
  constexpr double click_mm = 0.5;
  const double radius = window.center_W.head<2>().norm();
  const double error = click_mm / radius;
  const double weight = 1.0 / (error * error);
  const double before = 1.0 / (window.angleError * window.angleError);
  const double fraction = weight / (weight + before);
  RoundWindow mixed;
  mixed.angle = (weight * angle + before * window.angle) / (weight + before);
  mixed.angleError = 1.0 / std::sqrt(weight + before);
  const SineCosine turn = sineCosine(mixed.angle);
  const double mixedRadius = radius + fraction * (click_W.head<2>().norm() - radius);
  mixed.center_W = {mixedRadius * turn.cosine, mixedRadius * turn.sine,
                    window.center_W.z() + fraction * (click_W.z() - window.center_W.z())};
  mixed.isFound = true;
  return mixed;
}

}  // namespace perilymph::ct
