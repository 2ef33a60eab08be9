#pragma once

// The memory of the rod's solver, allocated once with the state.

#include <Eigen/Core>
#include <vector>

#include "contact/ContactSet.h"
#include "friction/FrictionHistory.h"
#include "rod/RodKinematics.h"
#include "solver/LinearSystem.h"

namespace perilymph::mechanics {

/// How inertia and drag hold each node in a time step.
struct NodeInertia {
  explicit NodeInertia(std::size_t nodes = 0) : hold(nodes), goal_W(nodes, Eigen::Vector3d::Zero())
  {
  }

  std::vector<double> hold;             ///< Stiffness with which they hold a node [N/m] ...
  std::vector<Eigen::Vector3d> goal_W;  ///< ... and the position at which they do [m].
};

/// Intermediate results of one time step. Nothing outlives it but `system.factors`. Functions that
/// need one part of it take that part; the solver's loops take it whole.
struct RodWorkspace {
  explicit RodWorkspace(std::size_t nodes = 0)
      : start(nodes),
        section(nodes),
        rod(nodes),
        twist(nodes),
        contacts(nodes),
        friction(nodes),
        inertia(nodes),
        force_W(nodes),
        system(nodes)
  {
  }

  StepStart start;
  SectionStiffness section;
  RodKinematics rod;
  TwistSystem twist;
  ContactSet contacts;
  FrictionHistory friction;
  NodeInertia inertia;
  std::vector<Eigen::Vector3d> force_W;  ///< On each node, of rod, wall and rim [N].
  LinearSystem system;
};

}  // namespace perilymph::mechanics
