// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Stick and slip of one sample point, with the three published coefficients.

#include <Eigen/Core>

#include "perilymph/mechanics/FrictionLaw.h"

namespace perilymph::mechanics {

/// Friction of the surface on one point in one step.
struct PointFriction {
  Eigen::Vector3d force_W;   ///< On the point, along the surface [N].
  Eigen::Vector3d spring_W;  ///< New deflection of the friction spring [m].
  bool isSliding;
};

/// Friction on a point on a tangential spring.
///
/// A resting point starts to slide when the spring's force exceeds the static coefficient times the
/// normal force. While it slides, the spring keeps the kinetic coefficient times the normal force
/// at any speed (the published law has no dependence on speed). It sticks again when the spring's
/// force has fallen below the stopping coefficient times the normal force. This meaning of the
/// three coefficients of the published interface is an interpretation (confidence medium).
///
/// @param stretch_W  Displacement of the point from where it stuck, along the surface [m].
/// @param normal     Normal force between point and surface [N], 0 or more.
/// @param stiffness  Of the spring [N/m].
///
/// Real-time safe.
PointFriction pointFriction(const Eigen::Vector3d& stretch_W, double normal, double stiffness,
                            bool wasSliding, const FrictionLaw& law) noexcept;

}  // namespace perilymph::mechanics
