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

/// Sliding of a node in the last step.
struct SlipBefore {
  bool isSliding;  ///< Whether it slid at its end.
  double speed;    ///< Along the wall [m/s].
};

/// Friction on a node that moved along the wall.
///
/// Where the coefficient rises with the speed, the force follows the speed in this step, with the
/// slope of the coefficient at the last one: taken from the last speed alone, a node would slide and
/// stop in alternate steps. Where it falls, it is that of the last speed, and the energy is convex.
///
/// @param stretch_W  Stored spring deflection plus this step's motion, tangent to the wall [m].
/// @param normal     Normal force between node and wall [N], 0 or more.
/// @param stiffness  Of the spring [N/m].
/// @param normal_W   Unit, off the wall.
/// @param timeStep   Duration of this step [s].
///
/// Real-time safe.
FrictionStep frictionStep(const Eigen::Vector3d& stretch_W, double normal, double stiffness,
                          const SlipBefore& before, const Eigen::Vector3d& normal_W,
                          const FrictionLaw& law, double timeStep) noexcept;

}  // namespace perilymph::mechanics
