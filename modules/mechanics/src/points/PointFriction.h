#pragma once

// Stick and slip of one sample point, by the three published coefficients.

#include <Eigen/Core>

#include "perilymph/mechanics/FrictionLaw.h"

namespace perilymph::mechanics {

/// What the surface's friction does to one point in one step.
struct PointFriction {
  Eigen::Vector3d force_W;   ///< On the point, along the surface [N].
  Eigen::Vector3d spring_W;  ///< How far it is held back from here on [m].
  bool isSliding;
};

/// Friction on a point on a tangential spring.
///
/// At rest it starts to slide when the spring's force exceeds *starting* times the normal force.
/// Sliding, the spring keeps *dynamic* times the normal force, at any speed (the published law has
/// no other). It rests again when the spring's force has fallen below *stopping* times the normal
/// force. That the three coefficients of the published interface mean this is a reading of it
/// (confidence medium).
///
/// @param stretch_W  How far the point is from where it was held, along the surface [m].
/// @param normal     Force that presses point and surface together [N], 0 or more.
/// @param stiffness  Of the spring [N/m].
///
/// Real-time safe.
PointFriction pointFriction(const Eigen::Vector3d& stretch_W, double normal, double stiffness,
                            bool wasSliding, const FrictionLaw& law) noexcept;

}  // namespace perilymph::mechanics
