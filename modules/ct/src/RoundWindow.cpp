#include "RoundWindow.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "perilymph/foundation/Math.h"
#include "perilymph/foundation/Units.h"

namespace perilymph::ct {
namespace {

// The map: a degree by 0.05 mm.
constexpr int columns = 64, rows = 64;
constexpr double firstAngle_deg = -25.0, lowest_mm = -1.6, rowStep_mm = 0.05;
constexpr double degree_mm = 0.1;  // along the wall, at a radius of 5.7 mm
constexpr double beyond_mm = 1.0;  // how far bone is looked for behind the fitted wall

// Over ten real ears the marked round window lies here in W, on average, with this spread.
constexpr double usual_deg = 7.0, usualSpread_deg = 9.0, usualHeight_mm = -0.05;
// Seen from the axis, the niche's opening lies ahead of the marked center: of ten real ears, each
// left out in turn, by 2.3 to 2.9 degrees, with a spread of 2.1.
constexpr double niche_deg = 2.5;
constexpr double foundSpread_deg = 3.5;

/// For every angle and height, how far from the axis bone begins; NaN where it does not.
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
        const auto value = volume.sample(
            state.pose.outOf_W({r * turn.cosine, r * turn.sine, heightOf(row)}));
        if (!value) break;
        if ((*value - middle) * sign > 0.0) {
          const double change = *value - valueBefore;
          const double share =
              r > before && change != 0.0 ? (middle - valueBefore) / change : 1.0;
          map[static_cast<std::size_t>(row * columns + column)] = before + share * (r - before);
          break;
        }
        before = r;
        valueBefore = *value;
      }
    }
  }
  return map;
}

/// The pixels without bone that hang together with the one nearest to the usual place.
std::vector<int> openingOf(const BoneMap& map)
{
  int seed = -1;
  double least = 1.5 * 1.5;  // [mm^2]
  for (int i = 0; i < columns * rows; ++i) {
    if (!std::isnan(map[static_cast<std::size_t>(i)])) continue;
    const double along = degree_mm * (firstAngle_deg + i % columns - usual_deg - niche_deg);
    const double up = heightOf(i / columns) - usualHeight_mm;
    if (along * along + up * up < least) {
      least = along * along + up * up;
      seed = i;
    }
  }
  std::vector<int> opening;
  if (seed < 0) return opening;
  std::vector<bool> isTaken(map.size());
  isTaken[static_cast<std::size_t>(seed)] = true;
  opening.push_back(seed);
  for (std::size_t next = 0; next < opening.size(); ++next) {
    const int column = opening[next] % columns, row = opening[next] / columns;
    const std::array<std::array<int, 2>, 4> neighbors{
        {{column - 1, row}, {column + 1, row}, {column, row - 1}, {column, row + 1}}};
    for (const auto& [c, r] : neighbors) {
      if (c < 0 || r < 0 || c >= columns || r >= rows) continue;
      const auto at = static_cast<std::size_t>(r * columns + c);
      if (isTaken[at] || !std::isnan(map[at])) continue;
      isTaken[at] = true;
      opening.push_back(r * columns + c);
    }
  }
  return opening;
}

/// Radius of the wall at a place of the map: a plane through what bone there is around the opening.
double radiusAcross(const BoneMap& map, const std::vector<int>& opening, double column, double row)
{
  Eigen::Matrix3d left = Eigen::Matrix3d::Identity() * 1e-6;
  Eigen::Vector3d right = Eigen::Vector3d::Zero();
  for (int i = 0; i < columns * rows; ++i) {
    const double radius = map[static_cast<std::size_t>(i)];
    if (std::isnan(radius)) continue;
    double least = 1e9;
    for (const int hole : opening) {
      const double along = degree_mm * (i % columns - hole % columns);
      const double up = rowStep_mm * (i / columns - hole / columns);
      least = std::min(least, along * along + up * up);
    }
    // Next to the hole the niche rounds the edge; far from it the wall is another.
    if (least < 0.14 * 0.14 || least > 0.4 * 0.4) continue;
    const Eigen::Vector3d term(1.0, degree_mm * (i % columns - column),
                               rowStep_mm * (i / columns - row));
    left += term * term.transpose();
    right += radius * term;
  }
  return left.ldlt().solve(right)[0];
}

}  // namespace

RoundWindow findRoundWindow(const CtVolume& volume, const ShapedLumen& lumen,
                            const FitState& state)
{
  const BoneMap map = mapOf(volume, lumen, state);
  const std::vector<int> opening = openingOf(map);
  RoundWindow window;
  double column = usual_deg - firstAngle_deg;
  double row = (usualHeight_mm - lowest_mm) / rowStep_mm;
  double radius = lumen.place(degrees(usual_deg).si()).outer;
  window.angleError = degrees(usualSpread_deg).si();
  const double area_mm2 = degree_mm * rowStep_mm * static_cast<double>(opening.size());
  if (area_mm2 > 0.15 && area_mm2 < 6.0) {
    double sumColumn = 0.0, sumRow = 0.0;
    for (const int hole : opening) {
      sumColumn += hole % columns;
      sumRow += hole / columns;
    }
    column = sumColumn / static_cast<double>(opening.size()) - niche_deg;
    row = sumRow / static_cast<double>(opening.size());
    const double across = radiusAcross(map, opening, column, row);
    const double byShape = lumen.place(angleOf(column)).outer;
    if (std::fabs(across - byShape) < 0.8) {
      radius = across;
      window.isFound = true;
      window.angleError = degrees(foundSpread_deg).si();
    }
  }
  window.angle = angleOf(column);
  const SineCosine turn = sineCosine(window.angle);
  window.center_W = {radius * turn.cosine, radius * turn.sine, heightOf(row)};
  return window;
}

}  // namespace perilymph::ct
