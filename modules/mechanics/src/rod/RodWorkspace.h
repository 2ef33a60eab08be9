// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Memory of the rod's solver, allocated once with the state.

#include <Eigen/Core>
#include <vector>

#include "contact/ContactSet.h"
#include "contact/Guide.h"
#include "friction/FrictionHistory.h"
#include "rod/RodKinematics.h"
#include "solver/LinearSystem.h"

namespace perilymph::mechanics {

/// Inertia and drag of each node in a time step, as a linear spring.
struct NodeInertia {
  explicit NodeInertia(std::size_t nodes = 0)
      : hold(3 * nodes), carried(3 * nodes), goal_W(nodes, Eigen::Vector3d::Zero())
  {
  }

  std::vector<double> hold;     ///< Stiffness of that spring along each axis [N/m].
  std::vector<double> carried;  ///< Time for which its rest position continues [s]; as often.
  std::vector<Eigen::Vector3d> goal_W;  ///< That rest position [m].
  double timeStep = 0.0;  ///< Time step for which the first two were computed [s]; 0: not yet.
};

/// Work done in one time step; SolverParameters bound it.
struct StepWork {
  int evaluations = 0;     ///< Evaluations of all forces.
  int factorizations = 0;  ///< Factorizations of the stiffness.
};

/// Intermediate results of one time step; only `system.factors` and a step that remains are kept
/// between steps. Functions that need one part take that part; the solver's loops take the whole
/// workspace.
struct RodWorkspace {
  explicit RodWorkspace(std::size_t nodes = 0)
      : start(nodes),
        prediction(nodes),
        section(nodes),
        rod(nodes),
        joints(nodes),
        twist(nodes),
        contacts(nodes),
        guide(nodes),
        friction(nodes),
        inertia(nodes),
        force_W(nodes),
        system(nodes)
  {
  }

  StepStart start;
  Prediction prediction;
  SectionStiffness section;
  RodKinematics rod;
  JointStiffness joints;
  TwistSystem twist;
  ContactSet contacts;
  GuideLine guide;
  FrictionHistory friction;
  NodeInertia inertia;
  std::vector<Eigen::Vector3d> force_W;  ///< Force of rod, wall and rim on each node [N].
  LinearSystem system;
  StepWork done;
};

}  // namespace perilymph::mechanics
