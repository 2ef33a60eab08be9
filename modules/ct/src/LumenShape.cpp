// SPDX-License-Identifier: BSD-3-Clause
#include "LumenShape.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <optional>

#include "perilymph/anatomy/Population.h"
#include "perilymph/foundation/Math.h"
#include "perilymph/foundation/Units.h"

namespace perilymph::ct {
namespace {

constexpr double tableStep = 2.0 * pi / 180.0;

// Prior standard deviations of what the population's four parameters do not determine. Sections
// vary by 9 to 15 % between individuals; the other values were chosen on phantoms and by
// leave-one-out on real ears.
constexpr double riseSpread = 0.15;
constexpr double widthSpread = 0.10;
constexpr double tiltSpread = 0.25;
constexpr double heightSpread = 0.12, heightBend = 0.10;
constexpr double radialSpread = 0.18, radialBend = 0.12;  // [mm] at a radius of 4 mm
constexpr double axialSpread = 0.15, axialBend = 0.10;    // [mm]

// Bony lumens are lower than the scala tympani with its mirror image, because the scala vestibuli
// is lower.
constexpr double meanHeightChange = -0.15;

void addSpline(Eigen::MatrixXd& precision, int first, int count, double spread, double bend)
{
  for (int i = 0; i < count; ++i) precision(first + i, first + i) += 1.0 / (spread * spread);
  for (int i = 1; i + 1 < count; ++i) {
    constexpr double second[3] = {1.0, -2.0, 1.0};
    for (int a = 0; a < 3; ++a)
      for (int b = 0; b < 3; ++b)
        precision(first + i - 1 + a, first + i - 1 + b) += second[a] * second[b] / (bend * bend);
  }
}

}  // namespace

SplineWeights splineWeights(double angle, double step_deg, int count)
{
  const double x =
      std::clamp((angle * (180.0 / pi) - shape::firstKnot_deg) / step_deg, 1.0, count - 2.001);
  const int i = static_cast<int>(x);
  const double t = x - i, s = 1.0 - t;
  return {i - 1,
          {s * s * s / 6.0, (3.0 * t * t * t - 6.0 * t * t + 4.0) / 6.0,
           (3.0 * s * s * s - 6.0 * s * s + 4.0) / 6.0, t * t * t / 6.0}};
}

LumenShape::LumenShape(const MeanLumen& mean) : mean_(mean)
{
  const anatomy::HalfDiameters center = anatomy::meanHalfDiameters();
  for (int i = 0; MeanLumen::firstAngle() + (i - 1) * tableStep <= mean.lastAngle(); ++i) {
    // The population's polynomial is valid from the round window on.
    const Angle angle = radians(std::max(0.0, MeanLumen::firstAngle() + i * tableStep));
    const double base = anatomy::outerWallRadius(center, angle);
    for (std::size_t k = 0; k < 4; ++k) {
      anatomy::HalfDiameters moved = center;
      double* const number[4] = {&moved.a1, &moved.b1, &moved.a2, &moved.b2};
      *number[k] += 1e-3;
      modes_[k].push_back(anatomy::outerWallRadius(moved, angle) / base - 1.0);
    }
  }
}

std::array<double, 4> LumenShape::populationModes(const LinePlace& place) const
{
  return {place.in(modes_[0]), place.in(modes_[1]), place.in(modes_[2]), place.in(modes_[3])};
}

SectionPlace LumenShape::place(const ShapeVector& q, double angle) const
{
  const auto radius = [&](double at) {
    double factor = 1.0;
    const std::array<double, 4> modes = populationModes(at);
    for (int i = 0; i < 4; ++i) factor += q[shape::half + i] * modes[static_cast<std::size_t>(i)];
    const SplineWeights fine = splineWeights(at, shape::knotStep_deg, shape::knots);
    for (int i = 0; i < 4; ++i)
      factor += 0.25 * q[shape::radial + fine.first + i] * fine.weight[static_cast<std::size_t>(i)];
    return factor * mean_.outerRadius(at);
  };
  const auto middle = [&](double at) {
    double z = (1.0 + q[shape::rise]) * mean_.height(at);
    const SplineWeights fine = splineWeights(at, shape::knotStep_deg, shape::knots);
    for (int i = 0; i < 4; ++i)
      z += q[shape::axial + fine.first + i] * fine.weight[static_cast<std::size_t>(i)];
    return z;
  };
  constexpr double step = 0.05;
  SectionPlace place{};
  place.outer = radius(angle);
  place.outerSlope = (radius(angle + step) - radius(angle - step)) / (2.0 * step);
  place.middle = middle(angle);
  place.middleSlope = (middle(angle + step) - middle(angle - step)) / (2.0 * step);
  const double perTurn = angle / (2.0 * pi) - 0.5;
  place.width = std::max(0.4, 1.0 + q[shape::width] + perTurn * q[shape::width + 1]);
  place.tilt = q[shape::tilt] + perTurn * q[shape::tilt + 1];
  const SplineWeights coarse = splineWeights(angle, shape::heightStep_deg, shape::heightKnots);
  place.height = 1.0;
  for (int i = 0; i < 4; ++i)
    place.height +=
        q[shape::height + coarse.first + i] * coarse.weight[static_cast<std::size_t>(i)];
  place.height = std::max(0.3, place.height);
  return place;
}

bool climbs(const LumenShape& family, const ShapeVector& q)
{
  return family.place(q, degrees(450).si()).middle > family.place(q, degrees(90).si()).middle;
}

ShapedLumen::ShapedLumen(const LumenShape& family, const ShapeVector& q) : mean_(family.mean())
{
  for (int i = 0; MeanLumen::firstAngle() + (i - 1) * tableStep <= mean_.lastAngle(); ++i)
    places_.push_back(family.place(q, MeanLumen::firstAngle() + i * tableStep));
}

SectionPlace ShapedLumen::place(const LinePlace& at) const
{
  const SectionPlace &a = places_[at.first], &b = places_[at.first + 1];
  const auto mix = [t = at.fraction](double from, double to) { return from + t * (to - from); };
  return {mix(a.outer, b.outer),   mix(a.outerSlope, b.outerSlope),
          mix(a.middle, b.middle), mix(a.middleSlope, b.middleSlope),
          mix(a.width, b.width),   mix(a.height, b.height),
          mix(a.tilt, b.tilt)};
}

/// A point beside one turn: its place, and the distance in the section with its spatial derivatives.
struct ShapedLumen::Beside {
  double angle, width;
  LinePlace line;
  SectionPlace at;
  double fromOuter, u, v;
  SectionDistance section;
  double gr, gz,
      gt;  ///< Derivatives of the distance in the section: outward, along the axis, around it.

  /// Squared length of the derivatives; by its root, not below `minSlope`, distances in space are shorter.
  double squaredSlope() const { return gr * gr + gz * gz + gt * gt; }
  double inside() const { return section.inside / std::max(minSlope, std::sqrt(squaredSlope())); }
  static constexpr double minSlope = 0.3;
};

template <class Visit>
void ShapedLumen::eachTurn(const Eigen::Vector3d& point_W, double r, double reach,
                           const Visit& visit) const
{
  double angle = arcTangent(point_W.y(), point_W.x());
  while (angle < MeanLumen::firstAngle()) angle += 2.0 * pi;
  for (; angle < mean_.lastAngle(); angle += 2.0 * pi) {
    // Turns out of reach are excluded by the mean shape alone, with a margin for individuals.
    const LinePlace line = mean_.placeOf(angle);
    const double width = mean_.width(line);
    if (std::fabs(r - mean_.outerRadius(line) + 0.5 * width) > 0.5 * width + reach + 1.6) continue;
    Beside turn{angle, width, line, place(line), 0.0, 0.0, 0.0, {}, 0.0, 0.0, 0.0};
    const SectionPlace& at = turn.at;
    turn.fromOuter = r - at.outer;
    turn.u = turn.fromOuter / at.width;
    turn.v = (point_W.z() - at.middle - at.tilt * turn.fromOuter) / at.height;
    turn.section = mean_.distance(angle, turn.u, turn.v);
    turn.gr = turn.section.du / at.width - turn.section.dv * at.tilt / at.height;
    turn.gz = turn.section.dv / at.height;
    turn.gt = -(turn.gr * at.outerSlope + turn.gz * at.middleSlope) / r;
    visit(turn);
  }
}

namespace {

/// Distance from the axis; empty where no turn is.
std::optional<double> radiusOf(const Eigen::Vector3d& point_W)
{
  const double r = std::sqrt(point_W.x() * point_W.x() + point_W.y() * point_W.y());
  return r < 1e-6 || r > 9.0 ? std::nullopt : std::optional<double>(r);
}

}  // namespace

std::optional<double> ShapedLumen::inside(const Eigen::Vector3d& point_W, double reach) const
{
  const auto r = radiusOf(point_W);
  std::optional<double> largest;
  if (!r) return largest;
  eachTurn(point_W, *r, reach, [&](const Beside& turn) {
    // out of reach, by more than rounding: without a root and a division
    const double out = std::min(0.0, turn.section.inside);
    constexpr double least = Beside::minSlope * Beside::minSlope;
    if (out * out > 1.000001 * reach * reach * std::max(least, turn.squaredSlope())) return;
    const double inside = turn.inside();
    if (inside >= -reach && (!largest || inside > *largest)) largest = inside;
  });
  return largest;
}

NearTurns ShapedLumen::distances(const Eigen::Vector3d& point_W, double reach) const
{
  NearTurns near;
  const auto r = radiusOf(point_W);
  if (!r) return near;
  const double cosine = point_W.x() / *r, sine = point_W.y() / *r;
  eachTurn(point_W, *r, reach, [&](const Beside& beside) {
    const auto& [angle, width, line, at, fromOuter, u, v, section, gr, gz, gt] = beside;
    TurnDistance turn;
    turn.inside = beside.inside();
    if (turn.inside < -reach || near.count == static_cast<int>(near.turn.size())) return;
    const double norm = std::max(Beside::minSlope, std::sqrt(beside.squaredSlope()));
    turn.angle = angle;
    turn.u = u;
    turn.width = width;
    turn.curvature = 2.0 / (0.5 * at.width * turn.width + at.height * mean_.halfHeight(line) + 0.1);
    turn.gradient = Eigen::Vector3d(gr * cosine - gt * sine, gr * sine + gt * cosine, gz) / norm;
    turn.byOuter = -gr / norm;
    turn.byMiddle = -gz / norm;
    turn.byWidth = -section.du * u / at.width / norm;
    turn.byHeight = -section.dv * v / at.height / norm;
    turn.byTilt = -section.dv * fromOuter / at.height / norm;
    if (near.nearest < 0 || turn.inside > near.turn[static_cast<std::size_t>(near.nearest)].inside)
      near.nearest = near.count;
    near.turn[static_cast<std::size_t>(near.count++)] = turn;
  });
  return near;
}

Eigen::MatrixXd LumenShape::priorPrecision() const
{
  Eigen::MatrixXd precision = Eigen::MatrixXd::Zero(shape::count, shape::count);
  const auto covariance = anatomy::halfDiameterCovariance();
  Eigen::Matrix4d population_mm2;
  for (int i = 0; i < 4; ++i)
    for (int k = 0; k < 4; ++k)
      population_mm2(i, k) =
          1e6 * covariance[static_cast<std::size_t>(i)][static_cast<std::size_t>(k)];
  precision.topLeftCorner<4, 4>() = population_mm2.inverse();
  precision(shape::rise, shape::rise) = 1.0 / (riseSpread * riseSpread);
  for (int i = 0; i < 2; ++i) {
    precision(shape::width + i, shape::width + i) = 1.0 / (widthSpread * widthSpread);
    precision(shape::tilt + i, shape::tilt + i) = 1.0 / (tiltSpread * tiltSpread);
  }
  addSpline(precision, shape::height, shape::heightKnots, heightSpread, heightBend);
  addSpline(precision, shape::radial, shape::knots, radialSpread, radialBend);
  addSpline(precision, shape::axial, shape::knots, axialSpread, axialBend);
  return precision;
}

ShapeVector LumenShape::priorMean()
{
  ShapeVector q = ShapeVector::Zero();
  q.segment<shape::heightKnots>(shape::height).setConstant(meanHeightChange);
  return q;
}

}  // namespace perilymph::ct
