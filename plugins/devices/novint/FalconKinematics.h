// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The mechanism of the Novint Falcon: three arms, each a motor, a thigh and a parallelogram, hold the
// grip so that it cannot turn (Stamper, A three degree of freedom parallel manipulator with only
// translational degrees of freedom, University of Maryland, 1997).

#include <optional>

#include "DeviceLink.h"

namespace perilymph::novint {

using plugin::Vector;

/// Lengths of the mechanism [m] and angles of its arms [rad], as libnifalcon 1.0 states them
/// (FalconGeometry.h, K. Ouellet; read on github.com/libnifalcon/libnifalcon). Confidence: medium;
/// measured by hobbyists, in agreement among several programs. Martin and Hillier (2009) measured
/// them, too; their paper was not consulted.
struct FalconGeometry {
  double thigh = 0.060;         ///< From the motor's axis to the knee.
  double shin = 0.1025;         ///< Side of the parallelogram.
  double shinOffsets = 0.0225;  ///< Knee to parallelogram and parallelogram to grip: 11.25 mm each.
  double gripU = 0.01443;       ///< From the shin's end to the center of the grip, outward.
  double gripV = -0.025;        ///< The same, sideways.
  double baseU = 0.0400;        ///< From the center of the base to the motor's axis, outward.
  double baseV = -0.02309;      ///< The same, sideways.
  /// Direction of each arm about z from x: 90, -30 and -150 degrees, turned by 15.
  Vector arms = {1.8325957145940461, -0.2617993877991494, -2.3561944901923448};
};

/// Angle of a thigh [rad] for a count of its encoder: 320 slots, counted four times, on a shaft of
/// 14.25 mm that drives the arm's sector of 110 mm; 35 degrees where homing sets the count to zero
/// (libnifalcon, as above; "approximately").
double armAngle(int count) noexcept;

/// Equilibrium and motion of the mechanism. Positions are those of the grip [m] in the frame of the
/// base: x right, y up, z toward the user, origin in the plane of the motors' axes.
///
/// Each arm, in its own plane with u outward, v sideways and w = z, obeys
///
///     (u + gripU - thigh cos q)^2 + (w - thigh sin q)^2 = (shinOffsets + l)^2
///     l = sqrt(shin^2 - (v + gripV)^2)
///
/// with q the angle of its thigh.
class FalconKinematics {
public:
  explicit FalconKinematics(const FalconGeometry& geometry = {}) noexcept;

  /// The position at three angles [rad], by Newton's method from a position nearby. None if there is
  /// none within reach.
  std::optional<Vector> position(const Vector& angles, const Vector& nearby) const noexcept;

  /// Torques of the motors [N m], referred to the thighs, that push the hand with a force [N]: by
  /// virtual work, torque . dq = force . dx. Zero where the mechanism is singular.
  Vector torques(const Vector& angles, const Vector& position, const Vector& force) const noexcept;

private:
  struct Arm {
    double residual;  // of the equation above, halved [m^2]
    Vector slope;     // its derivatives by x, y, z [m]
    double slopeByAngle;
  };
  std::optional<Arm> arm(std::size_t index, double angle, const Vector& position) const noexcept;

  FalconGeometry geometry_;
  Vector cosine_, sine_;
};

}  // namespace perilymph::novint
