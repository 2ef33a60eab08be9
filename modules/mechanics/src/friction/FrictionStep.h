// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Stick and slip of one node by return mapping of a friction spring.

#include <Eigen/Core>

#include "perilymph/mechanics/InsertionModel.h"

namespace perilymph::mechanics {

/// Friction of the wall on one node in one iteration.
struct FrictionStep {
  Eigen::Vector3d force_W = Eigen::Vector3d::Zero();   ///< On the node, tangent to the wall [N].
  Eigen::Vector3d spring_W = Eigen::Vector3d::Zero();  ///< New deflection of the spring [m].
  bool isSliding = false;                              ///< Whether the node slides.
  Eigen::Vector3d direction_W =
      Eigen::Vector3d::Zero();  ///< Unit vector in which it slips; zero where it sticks.
  double across = 0.0;          ///< Stiffness across that direction [N/m].
  double along = 0.0;           ///< Stiffness along it [N/m]; 0 where it sticks.

  /// Minus the force's derivative by the node's position [N/m]; positive semidefinite.
  ///
  /// @param normal_W  Unit, off the wall: perpendicular to the stretch.
  Eigen::Matrix3d stiffness(const Eigen::Vector3d& normal_W) const noexcept;
};

/// Friction of a contact by two springs side by side, a plain one and a relaxing film; without a film
/// only the first.
struct Friction {
  FrictionStep plain;
  FrictionStep film;
  bool hasFilm = false;

  Eigen::Vector3d force_W() const noexcept  ///< On the node, tangent to the wall [N].
  {
    return hasFilm ? Eigen::Vector3d(plain.force_W + film.force_W) : plain.force_W;
  }
  Eigen::Matrix3d stiffness(const Eigen::Vector3d& normal_W) const noexcept
  {
    const Eigen::Matrix3d stiffness = plain.stiffness(normal_W);
    return hasFilm ? Eigen::Matrix3d(stiffness + film.stiffness(normal_W)) : stiffness;
  }
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
/// @param timeStep   Duration of this step [s].
///
/// Real-time safe.
FrictionStep frictionStep(const Eigen::Vector3d& stretch_W, double normal, double stiffness,
                          const SlipBefore& before, const FrictionLaw& law,
                          double timeStep) noexcept;

/// The same with a film of model.film: of stiffness and friction, its fraction is that of a spring whose
/// stretch u relaxes with a time constant tau, in a step to (u + motion) / (1 + dt / tau). Its energy
/// never grows by that.
///
/// @param film_W     The film's stored stretch plus this step's motion, tangent to the wall [m].
Friction frictionWithFilm(const Eigen::Vector3d& stretch_W, const Eigen::Vector3d& film_W,
                          double normal, double stiffness, const SlipBefore& before,
                          const FrictionLaw& law, const InsertionModel& model) noexcept;

}  // namespace perilymph::mechanics
