// SPDX-License-Identifier: BSD-3-Clause
#include "importing/ModiolarAxis.h"

#include <Eigen/Geometry>
#include <cmath>

#include "numerics/DenseSolvers.h"
#include "perilymph/foundation/Math.h"

namespace perilymph::anatomy {
namespace {

constexpr double unit = 1e-3;  // lengths near 1 keep the problem well conditioned

/// An orthonormal frame with the given z and its x near `nearX`.
Eigen::Matrix3d axesAround(const Eigen::Vector3d& z, const Eigen::Vector3d& nearX)
{
  Eigen::Matrix3d axes;
  axes.col(2) = z.normalized();
  axes.col(0) = (nearX - nearX.dot(axes.col(2)) * axes.col(2)).normalized();
  axes.col(1) = axes.col(2).cross(axes.col(0));
  return axes;
}

/// A patch of the surface, in millimeters from the centroid.
struct Patch {
  Eigen::Vector3d place, normal;
  double area;  // fraction of the total area
};

/// Simultaneous rotation about the direction c, translation and scaling.
struct SpiralMotion {
  Eigen::Vector3d turning;  // unit
  Eigen::Vector3d sliding;
  double growth;

  Eigen::Vector3d at(const Eigen::Vector3d& place) const
  {
    return sliding + turning.cross(place) + growth * place;
  }
};

/// The motion with the smallest weighted mean square normal velocity over the surface.
SpiralMotion fittedMotion(const std::vector<Patch>& patches, const std::vector<double>& weights)
{
  // for each direction of rotation, the best-fitting translation and scaling
  std::array<LeastSquares, 3> best{LeastSquares(4), LeastSquares(4), LeastSquares(4)};
  for (std::size_t i = 0; i < patches.size(); ++i) {
    const Eigen::Vector3d& p = patches[i].place;
    const Eigen::Vector3d n = std::sqrt(weights[i]) * patches[i].normal;
    const Eigen::Vector3d moment = p.cross(n);
    const std::vector<double> row{n.x(), n.y(), n.z(), n.dot(p)};
    for (std::size_t k = 0; k < 3; ++k) best[k].add(row, -moment[static_cast<int>(k)]);
  }
  Eigen::Matrix<double, 4, 3> follows;
  for (int k = 0; k < 3; ++k) {
    const std::vector<double> x = best[static_cast<std::size_t>(k)].solve();
    for (int i = 0; i < 4; ++i) follows(i, k) = x[static_cast<std::size_t>(i)];
  }
  // the direction of rotation with the smallest residual
  Eigen::Matrix3d left = Eigen::Matrix3d::Zero();
  for (std::size_t i = 0; i < patches.size(); ++i) {
    const Eigen::Vector3d& p = patches[i].place;
    const Eigen::Vector3d n = std::sqrt(weights[i]) * patches[i].normal;
    const Eigen::Vector3d rest =
        p.cross(n) + follows.topRows<3>().transpose() * n + follows.row(3).transpose() * n.dot(p);
    left += rest * rest.transpose();
  }
  const Eigen3 directions(left);
  int smallest = 0;
  for (int k = 1; k < 3; ++k)
    if (directions.values[k] < directions.values[smallest]) smallest = k;
  const Eigen::Vector3d turning = directions.vectors.col(smallest);
  const Eigen::Vector4d rest = follows * turning;
  return {turning, rest.head<3>(), rest[3]};
}

}  // namespace

std::optional<AxisFrame> spiralAxis(const Surface& closed)
{
  constexpr int rounds = 40;
  // The hook region and the ends do not follow the spiral: a patch has half its weight if the
  // motion leaves the surface at this sine.
  constexpr double half = 0.1;

  const auto at = [&](int index) -> Eigen::Vector3d {
    const auto& p = closed.points[static_cast<std::size_t>(index)];
    return {p[0], p[1], p[2]};
  };
  double whole = 0.0;
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  for (const auto& t : closed.triangles) {
    const double area = 0.5 * (at(t[1]) - at(t[0])).cross(at(t[2]) - at(t[0])).norm();
    middle += area / 3.0 * (at(t[0]) + at(t[1]) + at(t[2]));
    whole += area;
  }
  middle /= whole;
  std::vector<Patch> patches;
  for (const auto& t : closed.triangles) {
    const Eigen::Vector3d across = (at(t[1]) - at(t[0])).cross(at(t[2]) - at(t[0]));
    const double twice = across.norm();
    if (twice > 0.0)
      patches.push_back({((at(t[0]) + at(t[1]) + at(t[2])) / 3.0 - middle) / unit, across / twice,
                         0.5 * twice / whole});
  }

  std::vector<double> weights;
  weights.reserve(patches.size());
  for (const Patch& patch : patches) weights.push_back(patch.area);
  SpiralMotion motion = fittedMotion(patches, weights);
  for (int round = 0; round < rounds; ++round) {
    for (std::size_t i = 0; i < patches.size(); ++i) {
      const Eigen::Vector3d velocity = motion.at(patches[i].place);
      const double speed2 = velocity.squaredNorm() + 1e-4;
      const double sine2 =
          velocity.dot(patches[i].normal) * velocity.dot(patches[i].normal) / speed2;
      weights[i] = patches[i].area / (speed2 * (1.0 + sine2 / (half * half)));
    }
    motion = fittedMotion(patches, weights);
  }
  if (motion.growth > 0.0)  // angles must increase as the surface shrinks
    motion = {-motion.turning, -motion.sliding, -motion.growth};

  // the point that the motion keeps on the axis: v + c x p + g p is parallel to the axis
  const Eigen::Vector3d& c = motion.turning;
  const Eigen::Vector3d across = motion.sliding - motion.sliding.dot(c) * c;
  const Eigen::Vector3d onAxis =
      (c.cross(across) - motion.growth * across) / (1.0 + motion.growth * motion.growth);
  if (!onAxis.allFinite() || onAxis.norm() > 5.0) return std::nullopt;
  const Eigen::Vector3d any =
      std::fabs(c.x()) < 0.8 ? Eigen::Vector3d(1.0, 0.0, 0.0) : Eigen::Vector3d(0.0, 1.0, 0.0);
  return AxisFrame{middle + unit * onAxis, axesAround(c, any)};
}

AxisFrame straightened(const AxisFrame& frame, const std::vector<AxialSection>& duct, double from,
                       double to)
{
  constexpr int degree = 4;
  constexpr int steps = 12;  // Gauss-Newton; the shifts are small
  constexpr std::size_t terms = degree + 1;

  double shiftX = 0.0, shiftY = 0.0, tiltX = 0.0, tiltY = 0.0;  // of the axis at z = 0
  for (int step = 0; step < steps; ++step) {
    LeastSquares fit(2 * terms + 4);
    const Eigen::Vector3d axis = Eigen::Vector3d(tiltX, tiltY, 1.0).normalized();
    for (const AxialSection& section : duct) {
      if (section.angle < from || section.angle > to) continue;
      const SineCosine turn = sineCosine(section.angle);
      const Eigen::Vector3d e =
          Eigen::Vector3d(section.centerRadius * turn.cosine, section.centerRadius * turn.sine,
                          section.centerHeight) /
              unit -
          Eigen::Vector3d(shiftX, shiftY, 0.0);
      const double z = e.dot(axis);
      const Eigen::Vector3d out = e - z * axis;
      const double r = out.norm();
      if (!(r > 0.05)) continue;
      const double c = out.x() / r, s = out.y() / r;
      const double angle = section.angle + arcTangent(s * turn.cosine - c * turn.sine,
                                                      c * turn.cosine + s * turn.sine);
      const double u = (2.0 * angle - from - to) / (to - from);

      // the row of log r, times r so that both rows are lengths; then the row of z
      std::vector<double> row(2 * terms + 4, 0.0);
      double power = 1.0;
      for (std::size_t k = 0; k < terms; ++k, power *= u) row[k] = r * power;
      row[2 * terms] = c;
      row[2 * terms + 1] = s;
      row[2 * terms + 2] = z * c;
      row[2 * terms + 3] = z * s;
      fit.add(row, r * logarithm(r));
      std::fill(row.begin(), row.end(), 0.0);
      power = 1.0;
      for (std::size_t k = 0; k < terms; ++k, power *= u) row[terms + k] = power;
      row[2 * terms + 2] = -r * c;
      row[2 * terms + 3] = -r * s;
      fit.add(row, z);
    }
    const std::vector<double> x = fit.solve();
    shiftX += x[2 * terms];
    shiftY += x[2 * terms + 1];
    tiltX += x[2 * terms + 2];
    tiltY += x[2 * terms + 3];
  }
  return {frame.outOf(unit * Eigen::Vector3d(shiftX, shiftY, 0.0)),
          axesAround(frame.axes * Eigen::Vector3d(tiltX, tiltY, 1.0), frame.axes.col(0))};
}

}  // namespace perilymph::anatomy
