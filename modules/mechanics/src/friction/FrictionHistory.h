// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Friction state of the previous step and the tentative one of this step.

#include <Eigen/Core>
#include <vector>

namespace perilymph::mechanics {

/// Friction in a step is bounded by the pressure at its start, and perpendicular to the normal
/// there.
struct FrictionHistory {
  explicit FrictionHistory(std::size_t nodes = 0)
      : pressedBefore(nodes),
        normalBefore_W(nodes, Eigen::Vector3d::Zero()),
        spring_W(nodes, Eigen::Vector3d::Zero()),
        film_W(nodes, Eigen::Vector3d::Zero()),
        slip(nodes),
        isSliding(nodes)
  {
  }

  std::vector<double> pressedBefore;            ///< Normal force that bounds friction [N].
  std::vector<Eigen::Vector3d> normalBefore_W;  ///< Unit: friction is perpendicular to it.
  double rimPressedBefore = 0.0;                ///< The same at the rim [N].
  Eigen::Vector3d rimNormalBefore_W = Eigen::Vector3d::Zero();
  std::vector<Eigen::Vector3d>
      spring_W;                         ///< After this iteration [m]; 0 of nodes that do not touch.
  std::vector<Eigen::Vector3d> film_W;  ///< The same of the relaxing film, if there is one.
  std::vector<double> slip;             ///< Slip of each node in this step [m].
  std::vector<unsigned char> isSliding;  ///< After this iteration.
};

}  // namespace perilymph::mechanics
