// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Force balance at the end of a step, and its derivative.

#include <Eigen/Core>

#include "perilymph/mechanics/InsertionModel.h"
#include "perilymph/mechanics/InsertionState.h"
#include "rod/RodStiffness.h"
#include "rod/RodWorkspace.h"

namespace perilymph::mechanics {

/// Free position of the base with spring coupling, and its stiffness.
struct Base {
  bool isHeld;                       ///< Rigid coupling.
  double inertia;                    ///< m / dt^2 [N/m]
  double effectiveStiffness;         ///< Spring and damper [N/m]
  Eigen::Vector3d free_W;            ///< Position due to inertia alone [m].
  Eigen::Vector3d couplingTarget_W;  ///< Position to which the coupling pulls it [m].
};

Base baseOf(const InsertionModel& model, const InsertionState& state, const Drive& drive) noexcept;

/// Sets inertia and drag of each node for this step.
void setHold(const InsertionModel& model, const InsertionState& state, const StepStart& start,
             NodeInertia& inertia) noexcept;

/// Norms of the unbalanced forces.
struct Residual {
  double maxNorm;      ///< Maximum unbalanced force on a block, along one axis [N].
  double squaredNorm;  ///< Sum of their squares [N^2].
  double total;        ///< Maximum of their sums along one axis: missing at the hand [N].
};

/// Computes all forces at state.position_W; stores the unbalanced ones in work.system.right.
Residual residual(const InsertionModel& model, InsertionState& state, const Base& base,
                  RodWorkspace& work) noexcept;

/// Fills work.system.matrix with the derivative of the last residual: minus the unbalanced forces
/// by the positions.
void assembleStiffness(const InsertionModel& model, const InsertionState& state, const Base& base,
                       Compression compression, RodWorkspace& work) noexcept;

}  // namespace perilymph::mechanics
