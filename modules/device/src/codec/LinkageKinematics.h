// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Kinematics of a handle at the end of a linkage that rotates about its base and is driven by
// capstans: the design of the open WoodenHaptics devices.

#include <array>

namespace perilymph::device {

/// Geometry and motors. Angle a rotates the whole arm about the vertical z; b and c tilt the two
/// links in the vertical plane of the arm: b from +z, c from -z, so that b = c = pi/2 stretches it
/// out. Each body is driven by a capstan on a motor with an encoder.
struct Linkage {
  double height = 0.0;                           ///< Height of the shoulder above the base [m].
  double lengthB = 0.0;                          ///< Shoulder to elbow [m].
  double lengthC = 0.0;                          ///< Elbow to handle [m].
  std::array<double, 3> origin_B{};              ///< D's origin in the base's frame B [m].
  std::array<double, 3> countsPerTurn{1, 1, 1};  ///< Encoder counts per turn of the motors.
  std::array<double, 3> bodyTurnsPerTurn{};      ///< Signed: turns of the body per turn of the
                                                 ///< motor.
  std::array<double, 3> restCounts{};            ///< Encoder counts at the calibration position.
  std::array<double, 3> torqueConstant{};        ///< [N.m/A]
  double maxCurrent = 0.0;                       ///< Maximum current of any motor [A].
};

/// Angles of the three bodies [rad] for encoder counts. Real-time safe.
std::array<double, 3> bodyAngles(const Linkage& linkage,
                                 const std::array<double, 3>& counts) noexcept;

/// Position of the handle relative to D's origin, in B [m]:
///
///     x = cos a (Lb sin b + Lc sin c)
///     y = sin a (Lb sin b + Lc sin c)
///     z = h + Lb cos b - Lc cos c         minus the origin
///
/// Real-time safe.
std::array<double, 3> handlePosition_B(const Linkage& linkage,
                                       const std::array<double, 3>& angles) noexcept;

/// Torques on the bodies that produce `force_B` [N] at the handle: J^T F [N.m]. Finite in every
/// pose: where a force cannot be produced (stretched out, or the handle above the base's axis), its
/// torque is zero. Real-time safe.
std::array<double, 3> bodyTorques(const Linkage& linkage, const std::array<double, 3>& angles,
                                  const std::array<double, 3>& force_B) noexcept;

/// Motor currents [A] for these torques, scaled down together to the maximum current, so that the
/// force keeps its direction. Zero for torques that are not finite. Real-time safe.
std::array<double, 3> motorCurrents(const Linkage& linkage,
                                    const std::array<double, 3>& torques) noexcept;

}  // namespace perilymph::device
