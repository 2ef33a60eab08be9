// SPDX-License-Identifier: BSD-3-Clause
#include "lumen/PlainLumens.h"

#include <Eigen/Geometry>
#include <cmath>

#include "perilymph/foundation/Hash.h"
#include "perilymph/foundation/Math.h"
#include "perilymph/foundation/Units.h"

namespace perilymph::anatomy {
namespace {

/// The wall of a round section around `axisPoint`, seen from `point`.
WallPoint roundWall(const Eigen::Vector3d& point, const Eigen::Vector3d& axisPoint,
                    const Eigen::Vector3d& alongDuct, double radius, double reach) noexcept
{
  WallPoint wall;
  const Eigen::Vector3d out = point - axisPoint;
  const double off = std::sqrt(out.x() * out.x() + out.y() * out.y() + out.z() * out.z());
  wall.isNear = radius - off < reach && off > 0.0;
  if (!wall.isNear) return wall;
  wall.distance = radius - off;
  wall.normal_W = -out / off;
  const Eigen::Vector3d around = alongDuct.cross(wall.normal_W);
  wall.shapeOperator_W = (1.0 / off) * around * around.transpose();
  return wall;
}

}  // namespace

void FlatWall::nearestWall(std::span<const Eigen::Vector3d> points_W, std::span<const double> reach,
                           std::span<LumenTrack>, std::span<WallPoint> walls) const noexcept
{
  for (std::size_t i = 0; i < points_W.size(); ++i) {
    WallPoint& wall = walls[i];
    wall = WallPoint{};
    const double distance = points_W[i].z() + depth_;
    if (points_W[i].z() > 0.0 || distance > reach[i]) continue;
    wall.isNear = true;
    wall.distance = distance;
    wall.normal_W = Eigen::Vector3d::UnitZ();
  }
}

void StraightTube::nearestWall(std::span<const Eigen::Vector3d> points_W,
                               std::span<const double> reach, std::span<LumenTrack>,
                               std::span<WallPoint> walls) const noexcept
{
  for (std::size_t i = 0; i < points_W.size(); ++i) {
    const Eigen::Vector3d& p = points_W[i];
    walls[i] = p.z() > 0.0
                   ? WallPoint{}
                   : roundWall(p, {0.0, 0.0, p.z()}, -Eigen::Vector3d::UnitZ(), radius_, reach[i]);
  }
}

void CircularDuct::nearestWall(std::span<const Eigen::Vector3d> points_W,
                               std::span<const double> reach, std::span<LumenTrack> tracks,
                               std::span<WallPoint> walls) const noexcept
{
  for (std::size_t i = 0; i < points_W.size(); ++i) {
    const Eigen::Vector3d& p = points_W[i];
    walls[i] = WallPoint{};
    if (p.z() > 0.0 && tracks[i].isNearOpening()) continue;
    if (p.z() > -lead_ && tracks[i].isNearOpening()) {
      tracks[i] = LumenTrack{};
      walls[i] = roundWall(p, {0.0, 0.0, p.z()}, -Eigen::Vector3d::UnitZ(), radius_, reach[i]);
      continue;
    }
    // on the circle: the angle from the +x direction at its center, growing toward -z
    const double x = p.x() + bend_;
    const double z = -(p.z() + lead_);
    const double r = std::sqrt(x * x + z * z);
    if (!(r > 0.0)) continue;
    const double cosine = x / r;
    const double sine = z / r;
    tracks[i].inLeadIn = false;
    double angle = arcTangent(sine, cosine);
    while (angle < tracks[i].angle - pi) angle += 2.0 * pi;
    while (angle > tracks[i].angle + pi) angle -= 2.0 * pi;
    tracks[i].angle = angle;
    const Eigen::Vector3d axisPoint(bend_ * cosine - bend_, 0.0, -bend_ * sine - lead_);
    walls[i] = roundWall(p, axisPoint, {-sine, 0.0, -cosine}, radius_, reach[i]);
    const Eigen::Vector3d along(-sine, 0.0, -cosine);
    const double outward = walls[i].normal_W.x() * cosine - walls[i].normal_W.z() * sine;
    if (outward < 0.0) walls[i].shapeOperator_W += (-outward / r) * along * along.transpose();
  }
}

void FlatWall::addTo(Hash& hash) const noexcept { hash.add(depth_); }

void StraightTube::addTo(Hash& hash) const noexcept { hash.add(radius_); }

void CircularDuct::addTo(Hash& hash) const noexcept
{
  for (const double value : {radius_, bend_, lead_}) hash.add(value);
}

}  // namespace perilymph::anatomy
