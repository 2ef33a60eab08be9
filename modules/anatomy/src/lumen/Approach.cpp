// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/anatomy/Approach.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "perilymph/foundation/Math.h"

namespace perilymph::anatomy {

namespace {

/// Angle of a unit vector with z = `sine` to the plane across z [rad].
double elevation(double sine)
{
  return arcTangent(sine, std::sqrt(std::max(0.0, 1.0 - sine * sine)));
}

Angle limited(Angle angle)
{
  const double hundredths = std::round(100.0 * inDegrees(angle));
  constexpr double most = 100.0 * steepestApproach_deg;
  return degrees(std::clamp(hundredths, -most, most) / 100.0);
}

}  // namespace

Eigen::Vector3d directionOf(const Approach& approach, const Entry& entry) noexcept
{
  const SineCosine tilt = sineCosine(approach.tilt.si());
  const SineCosine turn = sineCosine(approach.turn.si());
  return -(tilt.cosine * turn.cosine) * entry.out_W + tilt.sine * entry.vertical_W +
         (tilt.cosine * turn.sine) * entry.outward_W;
}

Approach approachAlong(const Eigen::Vector3d& into_W, const Entry& entry) noexcept
{
  const Eigen::Vector3d into = into_W.normalized();
  return {radians(elevation(into.dot(entry.vertical_W))),
          radians(arcTangent(into.dot(entry.outward_W), -into.dot(entry.out_W)))};
}

Approach withinLimits(const Approach& approach) noexcept
{
  return {limited(approach.tilt), limited(approach.turn)};
}

BasalTurnAngles anglesToBasalTurn(const Approach& approach, const Entry& entry) noexcept
{
  const Eigen::Vector3d into = directionOf(approach, entry), tangent = -entry.out_W;
  // in the plane, counterclockwise seen from the apex is into the spiral, away from the lateral wall
  const double across = into.x() * tangent.y() - into.y() * tangent.x();
  const double along = into.x() * tangent.x() + into.y() * tangent.y();
  return {radians(arcTangent(across, along)),
          radians(elevation(into.z()) - elevation(tangent.z()))};
}

Approach approachAt(const BasalTurnAngles& angles, const Entry& entry) noexcept
{
  const Eigen::Vector3d tangent = -entry.out_W;
  const SineCosine turn = sineCosine(arcTangent(tangent.y(), tangent.x()) - angles.inPlane.si());
  const SineCosine rise = sineCosine(elevation(tangent.z()) + angles.outOfPlane.si());
  return approachAlong({rise.cosine * turn.cosine, rise.cosine * turn.sine, rise.sine}, entry);
}

}  // namespace perilymph::anatomy
