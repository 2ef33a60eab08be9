// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Places in the ear: from the frame of the CT to the turn of the scala tympani and back.

#include <Eigen/Core>
#include <vector>

#include "perilymph/outcome/FoundArray.h"

namespace perilymph::outcome {

/// Place of a point relative to the scala tympani.
struct EarPlace {
  double angle = 0.0;     ///< From the round window [rad], full turns included; below 0 before it.
  double depth_mm = 0.0;  ///< Along the section centers from the opening; negative outside.
  double across_mm =
      0.0;  ///< Distance from the center of both scalae in the half-plane, or from the opening's axis.
  double radius_mm = 0.0;  ///< Distance from the modiolar axis.
  bool isInside = false;   ///< Past the opening.
  bool isNearDuct =
      false;  ///< In the duct or so near to it as blurred metal in it; before the opening near its axis.
};

/// The ear's frame W [m] in the CT, P [mm].
class EarFrame {
public:
  explicit EarFrame(const Ear& ear);

  Eigen::Vector3d toW(const Eigen::Vector3d& point_P) const
  {
    return 1e-3 * (axes_.transpose() * (point_P - origin_));
  }
  Eigen::Vector3d toP(const Eigen::Vector3d& point_W) const
  {
    return origin_ + 1e3 * (axes_ * point_W);
  }
  Eigen::Vector3d directionToP(const Eigen::Vector3d& direction_W) const
  {
    return axes_ * direction_W;
  }

  /// The place of a point in P, in the turn whose duct is nearest.
  EarPlace placeOf(const Eigen::Vector3d& point_P) const;
  /// The part of bone at a point in P, 0 in both scalae, 1 in the bone, with an edge as wide as the blur; 1 far from
  /// the duct.
  double bonePart(const Eigen::Vector3d& point_P, double blur_mm) const;
  /// Largest angle of the scala tympani [rad].
  double lastAngle() const { return lastAngle_; }
  /// Arc length of the section centers from the opening to an angle [mm].
  double depthAt(double angle) const;

private:
  Eigen::Matrix3d axes_;
  Eigen::Vector3d origin_;
  anatomy::Entry entry_;
  std::shared_ptr<const anatomy::ScalaTympani> both_;
  double lastAngle_ = 0.0, step_ = 0.0, leadIn_mm_ = 0.0;
  std::vector<double> radius_, height_,
      depth_;  ///< Course of both scalae [mm], at multiples of the step.
};

}  // namespace perilymph::outcome
