#pragma once

// What the array and the rim of the opening remember of each other.

#include <Eigen/Core>

namespace perilymph::mechanics {

struct RimContact {
  Eigen::Vector3d spring_W = Eigen::Vector3d::Zero();  ///< How far friction holds it back [m].
  bool isSliding = false;
  Eigen::Vector3d normal_W = Eigen::Vector3d::Zero();  ///< Unit, that friction lies across.
  double slipSpeed = 0.0;                              ///< Speed of the array along the rim [m/s].
  double fromTip = 0.0;                                ///< Where the array passes it [m].
  double normalForce = 0.0;                            ///< All normal parts together [N].
  Eigen::Vector3d force_W = Eigen::Vector3d::Zero();   ///< Force of the rim on the array [N].
};

}  // namespace perilymph::mechanics
