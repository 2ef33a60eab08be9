#pragma once

// The balance of forces that ends a step, and its derivative.

#include <Eigen/Core>

#include "perilymph/mechanics/InsertionModel.h"
#include "perilymph/mechanics/InsertionState.h"
#include "rod/Rod.h"
#include "rod/RodWorkspace.h"

namespace perilymph::mechanics {

/// Where the base would go by itself in spring coupling, and how hard it is held.
struct Base {
  bool isHeld;                       ///< Rigid coupling.
  double inertia;                    ///< m / dt^2 [N/m]
  double effectiveStiffness;         ///< Spring and damper [N/m]
  Eigen::Vector3d free_W;            ///< Where inertia alone takes it [m].
  Eigen::Vector3d couplingTarget_W;  ///< Where the coupling pulls it [m].
};

/// @param timeStep  Of the step, or of the part of it that is taken [s].
Base baseOf(const InsertionModel& model, const InsertionState& state, const Drive& drive,
            double timeStep) noexcept;

/// How inertia and drag hold each node in this step.
void setHold(const InsertionModel& model, const InsertionState& state, const StepStart& start,
             NodeInertia& inertia) noexcept;

/// What is left unbalanced.
struct Residual {
  double maxNorm;      ///< Greatest unbalanced force on a block, along one axis [N].
  double squaredNorm;  ///< Sum of their squares [N^2].
};

/// All forces at state.position_W. Leaves those that are unbalanced in work.system.right.
Residual residual(const InsertionModel& model, InsertionState& state, const Base& base,
                  RodWorkspace& work) noexcept;

/// Fills work.system.matrix with the derivative of the last balance: minus the unbalanced forces by
/// the positions.
void assembleStiffness(const InsertionModel& model, const Base& base, Compression compression,
                       RodWorkspace& work) noexcept;

}  // namespace perilymph::mechanics
