// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// State of the contact between the array and the rim of the opening.

#include <Eigen/Core>

namespace perilymph::mechanics {

struct RimContact {
  Eigen::Vector3d spring_W = Eigen::Vector3d::Zero();  ///< Deflection of the friction spring [m].
  Eigen::Vector3d film_W = Eigen::Vector3d::Zero();    ///< The same of its film, if it has one [m].
  bool isSliding = false;
  Eigen::Vector3d normal_W = Eigen::Vector3d::Zero();  ///< Unit; friction is perpendicular to it.
  double slipSpeed = 0.0;                              ///< Speed of the array along the rim [m/s].
  double fromTip = 0.0;                                ///< Point of the array at the rim, from the
                                                       ///< tip [m].
  double normalForce = 0.0;                            ///< Sum of the normal force components [N].
  Eigen::Vector3d force_W = Eigen::Vector3d::Zero();   ///< Force of the rim on the array [N].
};

}  // namespace perilymph::mechanics
