#pragma once

// Room for the intermediate results of one step, allocated once with the state. Nothing in it
// outlives a step.

#include <Eigen/Core>
#include <vector>

#include "perilymph/anatomy/Lumen.h"
#include "perilymph/mechanics/BandSystem.h"
#include "perilymph/mechanics/RimContact.h"

namespace perilymph::mechanics {

struct StepRoom {
  explicit StepRoom(std::size_t nodes = 0)
      : system(nodes > 0 ? nodes - 1 : 0),
        force_W(nodes),
        before_W(nodes),
        start_W(nodes),
        trial_W(nodes),
        bending(nodes),
        restBend(nodes),
        restBend_W(nodes, Eigen::Vector3d::Zero()),
        lengthBefore(nodes),
        bendBefore_W(nodes, Eigen::Vector3d::Zero()),
        reach(nodes),
        wall(nodes),
        frictionSpring_W(nodes),
        slip(nodes),
        isSliding(nodes)
  {
  }

  BandSystem system;
  std::vector<Eigen::Vector3d> force_W;           ///< On each node, rod and wall [N].
  std::vector<Eigen::Vector3d> before_W;          ///< Positions at the start of the step [m].
  std::vector<Eigen::Vector3d> start_W;           ///< Where this Newton step starts from [m].
  std::vector<Eigen::Vector3d> trial_W;           ///< The Newton step itself, per block [m].
  std::vector<double> bending;                    ///< EI at each node [N.m^2].
  std::vector<double> restBend;                   ///< Spacing times rest curvature at each node.
  std::vector<Eigen::Vector3d> restBend_W;        ///< The same, with its direction.
  std::vector<double> lengthBefore;               ///< Of each edge at the start of the step [m].
  std::vector<Eigen::Vector3d> bendBefore_W;      ///< At each node at the start of the step.
  std::vector<double> reach;                      ///< Of the lumen query at each node [m].
  std::vector<anatomy::WallPoint> wall;           ///< As each node sees it.
  std::vector<Eigen::Vector3d> frictionSpring_W;  ///< As this iteration would leave it [m].
  std::vector<double> slip;                       ///< Of each node in this step [m].
  std::vector<unsigned char> isSliding;           ///< As this iteration would leave it.
  RimContact rim;                                 ///< As this iteration would leave it.
};

}  // namespace perilymph::mechanics
