// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Friction state of the previous step and the tentative one of this step.

#include <Eigen/Core>
#include <vector>

#include "friction/FrictionKernel.h"
#include "friction/FrictionStep.h"
#include "lanes/Lanes.h"

namespace perilymph::mechanics {

/// What the stiffness of the friction on each node follows from, of one of its springs.
struct FrictionStiffness {
  explicit FrictionStiffness(std::size_t nodes = 0)
      : direction_W(nodes), across(nodes), along(nodes)
  {
  }

  /// FrictionStep::stiffness() of a node.
  Eigen::Matrix3d at(std::size_t i, const Eigen::Vector3d& normal_W) const noexcept
  {
    FrictionStep step;
    step.direction_W = direction_W[i];
    step.across = across[i];
    step.along = along[i];
    return step.stiffness(normal_W);
  }

  Axes direction_W;            ///< FrictionStep::direction_W
  std::vector<double> across;  ///< FrictionStep::across
  std::vector<double> along;   ///< FrictionStep::along
};

template <class T>
PERILYMPH_IN_LANES void store(const FrictionStepOf<T>& step, FrictionStiffness& to,
                              std::size_t i) noexcept
{
  store(step.direction_W, to.direction_W, i);
  store(step.across, to.across, i);
  store(step.along, to.along, i);
}

/// Friction in a step is bounded by the pressure that is expected at its end, and perpendicular to
/// the normal at its start.
struct FrictionHistory {
  explicit FrictionHistory(std::size_t nodes = 0)
      : pressedBefore(nodes),
        normalBefore_W(nodes, Eigen::Vector3d::Zero()),
        spring_W(nodes, Eigen::Vector3d::Zero()),
        film_W(nodes, Eigen::Vector3d::Zero()),
        slip(nodes),
        isSliding(nodes),
        plain(nodes),
        film(nodes)
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
  FrictionStiffness plain;  ///< Set at nodes with a normal force that bounds friction ...
  FrictionStiffness film;   ///< ... and of their film, if there is one.
};

}  // namespace perilymph::mechanics
