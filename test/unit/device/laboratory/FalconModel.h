// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The Falcon's mechanism from the other side: from a position to the angles of its thighs in closed
// form, by the law of cosines in the plane of each arm, and from torques to a force by differences.

#include <cmath>

#include "FalconKinematics.h"

namespace perilymph::test {

/// The angle of a thigh [rad] at a position [m] in the frame of the base.
inline double thighAngle(std::size_t arm, const std::array<double, 3>& position)
{
  const novint::FalconGeometry falcon;
  const double turn = falcon.arms[arm];
  const double u = position[0] * std::cos(turn) + position[1] * std::sin(turn) - falcon.baseU;
  const double v = position[1] * std::cos(turn) - position[0] * std::sin(turn) - falcon.baseV;
  const double shin = std::sqrt(std::pow(falcon.shin, 2) - std::pow(v + falcon.gripV, 2));
  const double length = falcon.shinOffsets + shin;
  // A triangle of the motor's axis, the knee and the shin's end.
  const double out = u + falcon.gripU, up = position[2];
  const double distance = std::hypot(out, up);
  const double atMotor =
      std::acos((std::pow(distance, 2) + std::pow(falcon.thigh, 2) - std::pow(length, 2)) /
                (2.0 * distance * falcon.thigh));
  return std::atan2(up, out) - atMotor;
}

/// The force on the hand [N] of torques on the thighs [N m]: sum of torque times dq/dx.
inline std::array<double, 3> forceOf(const std::array<double, 3>& torques,
                                     const std::array<double, 3>& position)
{
  constexpr double step = 1e-6;  // [m]
  std::array<double, 3> force{};
  for (std::size_t k = 0; k < 3; ++k) {
    auto before = position, after = position;
    before[k] -= step;
    after[k] += step;
    for (std::size_t i = 0; i < 3; ++i)
      force[k] += torques[i] * (thighAngle(i, after) - thighAngle(i, before)) / (2.0 * step);
  }
  return force;
}

}  // namespace perilymph::test
