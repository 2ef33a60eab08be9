// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Rigid registration of two CTs around a cochlea: bone against bone, without metal.

#include <Eigen/Core>
#include <functional>
#include <stop_token>

#include "perilymph/ct/CtVolume.h"

namespace perilymph::outcome {

/// x -> rotation (x - center) + center + shift takes a point of the first CT to the second.
struct RigidMotion {
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
  Eigen::Vector3d center = Eigen::Vector3d::Zero(), shift = Eigen::Vector3d::Zero();
  double correlation = 0.0;  ///< Correlation of both CTs there, without metal.
  double residual_mm = 0.0;  ///< Root mean square difference over root mean square gradient.

  Eigen::Vector3d apply(const Eigen::Vector3d& point) const
  {
    return rotation * (point - center) + center + shift;
  }
};

/// Finds the motion that takes the surroundings of a point of the first CT to the second, from starts over
/// all its places and 24 degrees about each axis.
/// @param onProgress  Completed fraction, 0 to 1, on the calling thread.
Result<RigidMotion> registration(const ct::CtVolume& from, const Eigen::Vector3d& center_P,
                                 const ct::CtVolume& to, const std::stop_token& stop,
                                 const std::function<void(double)>& onProgress = {});

}  // namespace perilymph::outcome
