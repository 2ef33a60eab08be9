// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Stick and slip of one node by return mapping of a friction spring.

#include <Eigen/Core>

#include "perilymph/mechanics/FrictionLaw.h"

namespace perilymph::mechanics {

/// Friction of the wall on one node in one iteration.
struct FrictionStep {
  Eigen::Vector3d force_W;  ///< On the node, tangent to the wall [N].
  Eigen::Matrix3d
      stiffness;  ///< Minus the force's derivative by the node's position [N/m]; positive
                  ///< semidefinite.
  Eigen::Vector3d spring_W;  ///< New deflection of the spring [m].
  bool isSliding;            ///< Whether the node slides.
};

/// Friction on a node that moved along the wall.
///
/// @param stretch_W  Stored spring deflection plus this step's motion, tangent to the wall [m].
/// @param normal     Normal force between node and wall [N], 0 or more.
/// @param stiffness  Of the spring [N/m].
/// @param isSliding  Whether the node slid at the end of the last step.
/// @param slipSpeed  Its speed along the wall in the last step [m/s].
/// @param normal_W   Unit, off the wall.
///
/// Real-time safe.
FrictionStep frictionStep(const Eigen::Vector3d& stretch_W, double normal, double stiffness,
                          bool isSliding, double slipSpeed, const Eigen::Vector3d& normal_W,
                          const FrictionLaw& law) noexcept;

}  // namespace perilymph::mechanics
