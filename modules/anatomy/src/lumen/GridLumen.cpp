// SPDX-License-Identifier: BSD-3-Clause
#include "lumen/GridLumen.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "mesh/SignedDistance.h"
#include "numerics/CubicTable.h"
#include "numerics/DenseSolvers.h"
#include "perilymph/foundation/Hash.h"
#include "perilymph/foundation/Math.h"
#include "perilymph/foundation/Units.h"

namespace perilymph::anatomy {
namespace {

constexpr double outside = 0.3e-3;  // the table extends this far beyond the wall [m]
constexpr double deepest = 0.9e-3;  // the largest circle in a mean section has a diameter of 1.25
                                    // mm [m]
constexpr double nearLid = 2.5e-3;  // within this distance of the opening its lid may be nearest
                                    // [m]

// Far within one grid step: the third derivatives are bounded by D's slope over the step squared.
constexpr double trusted = 0.2e-6;  // [m]

/// The negative of a second derivative, projected onto its positive semidefinite part.
Eigen::Matrix3d positivePart(const Eigen::Matrix3d& bend) noexcept
{
  const Eigen3 parts(-bend);
  Eigen::Matrix3d positive = Eigen::Matrix3d::Zero();
  for (int k = 0; k < 3; ++k) {
    if (!(parts.values[k] > 0.0)) continue;
    const Eigen::Vector3d direction = parts.vectors.col(k);
    positive += parts.values[k] * direction * direction.transpose();
  }
  return positive;
}

}  // namespace

GridLumen::GridLumen(const Surface& wall, const Surface& closed, const Entry& entry)
    : entry_(entry), low_W_(Eigen::Vector3d::Constant(1e9))
{
  Eigen::Vector3d high_W = Eigen::Vector3d::Constant(-1e9);
  for (const auto& t : wall.triangles)
    for (const int index : t) {
      const auto& p = wall.points[static_cast<std::size_t>(index)];
      low_W_ = low_W_.cwiseMin(Eigen::Vector3d(p[0], p[1], p[2]));
      high_W = high_W.cwiseMax(Eigen::Vector3d(p[0], p[1], p[2]));
    }
  low_W_ -= Eigen::Vector3d::Constant(outside);
  for (int axis = 0; axis < 3; ++axis)
    size_[axis] =
        static_cast<int>(std::ceil((high_W[axis] + outside - low_W_[axis]) / spacing)) + 3;

  const SignedDistance side(closed);
  const SurfaceDistance toWall(wall);
  distance_.reserve(static_cast<std::size_t>(size_[0]) * static_cast<std::size_t>(size_[1]) *
                    static_cast<std::size_t>(size_[2]));
  for (int i = 0; i < size_[0]; ++i)
    for (int j = 0; j < size_[1]; ++j)
      for (int k = 0; k < size_[2]; ++k) {
        const Eigen::Vector3d point = low_W_ + spacing * Eigen::Vector3d(i, j, k);
        double distance = side.at(point, deepest, -outside);
        // the lid determines the side but is not wall
        if ((point - entry_.origin_W).norm() < nearLid) {
          const SurfaceFoot foot = toWall.nearest(point, deepest);
          const double off = foot.triangle < 0 ? deepest : foot.distance;
          distance = distance > 0.0 ? off : -off;
        }
        distance_.push_back(static_cast<float>(std::max(distance, -outside)));
      }
}

void GridLumen::nearestWall(std::span<const Eigen::Vector3d> points_W,
                            std::span<const double> reach, std::span<LumenTrack> tracks,
                            std::span<WallPoint> walls) const noexcept
{
  for (std::size_t i = 0; i < points_W.size(); ++i)
    locate(points_W[i], reach[i], tracks[i], walls[i]);
}

bool GridLumen::track(const Eigen::Vector3d& point_W, LumenTrack& track) const noexcept
{
  const double behind = behindOpening(entry_, point_W, track);
  if (!(behind >= 0.0) || !point_W.allFinite()) {  // outside or not finite
    track = LumenTrack{};
    return false;
  }

  // the angle, in the turn stored in the track
  if (track.isNearOpening() && point_W.x() > 0.0 && point_W.y() < 0.0) {
    track = LumenTrack{};
  } else {
    const double r = std::sqrt(point_W.x() * point_W.x() + point_W.y() * point_W.y());
    if (r > 1e-6) {
      const double x = point_W.x() / r;
      const double y = point_W.y() / r;
      track.angle += arcTangent(y * track.direction[0] - x * track.direction[1],
                                x * track.direction[0] + y * track.direction[1]);
      track.direction[0] = x;
      track.direction[1] = y;
      track.inLeadIn = false;
    }
  }
  return true;
}

void GridLumen::follow(const Eigen::Vector3d& point_W, LumenTrack& track) const noexcept
{
  this->track(point_W, track);
}

void GridLumen::locate(const Eigen::Vector3d& point_W, double reach, LumenTrack& memory,
                       WallPoint& wall) const noexcept
{
  wall.isNear = false;
  wall.onMembrane = false;
  if (!track(point_W, memory)) return;

  // the spline's value, gradient and second derivatives by the indices
  std::size_t first[3];
  double fraction[3];
  for (int axis = 0; axis < 3; ++axis) {
    const double index = (point_W[axis] - low_W_[axis]) / spacing - 1.0;
    if (!(index >= 0.0 && index < size_[axis] - 3)) return;  // no wall beyond the table
    first[axis] = static_cast<std::size_t>(index);
    fraction[axis] = index - static_cast<double>(first[axis]);
  }
  const CubicWeights x(fraction[0]), y(fraction[1]), z(fraction[2]);
  double D = 0.0;
  Eigen::Vector3d slope = Eigen::Vector3d::Zero();
  double xx = 0.0, xy = 0.0, xz = 0.0, yy = 0.0, yz = 0.0, zz = 0.0;
  const auto columns = static_cast<std::size_t>(size_[1]);
  const auto rowLength = static_cast<std::size_t>(size_[2]);
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < 4; ++j) {
      const float* const row =
          distance_.data() + ((first[0] + i) * columns + first[1] + j) * rowLength + first[2];
      const double c[4] = {row[0], row[1], row[2], row[3]};
      const double v = weighted(c, z.value), s = weighted(c, z.slope), b = weighted(c, z.bend);
      D += x.value[i] * y.value[j] * v;
      slope += Eigen::Vector3d(x.slope[i] * y.value[j] * v, x.value[i] * y.slope[j] * v,
                               x.value[i] * y.value[j] * s);
      xx += x.bend[i] * y.value[j] * v;
      yy += x.value[i] * y.bend[j] * v;
      zz += x.value[i] * y.value[j] * b;
      xy += x.slope[i] * y.slope[j] * v;
      xz += x.slope[i] * y.value[j] * s;
      yz += x.value[i] * y.slope[j] * s;
    }
  wall.distance = D;
  if (D > reach) return;
  wall.isNear = true;
  wall.normal_W = slope / spacing;
  Eigen::Matrix3d bend;
  bend << xx, xy, xz, xy, yy, yz, xz, yz, zz;
  wall.hessian_W = bend / (spacing * spacing);
  wall.shapeOperator_W = positivePart(wall.hessian_W);
  wall.trustRadius = trusted;
}

void GridLumen::addTo(Hash& hash) const noexcept
{
  for (const Eigen::Vector3d& vector :
       {entry_.origin_W, entry_.out_W, entry_.outward_W, entry_.vertical_W, low_W_})
    for (const double value : vector) hash.add(value);
  for (const int samples : size_) hash.add(samples);
  hash.addBytes(distance_.data(), distance_.size() * sizeof distance_.front());
}

}  // namespace perilymph::anatomy
