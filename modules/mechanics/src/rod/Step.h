// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// One time step or substep: attempted, then committed or rolled back.

#include "solver/Newton.h"

namespace perilymph::mechanics {

/// Solution strategy of a step.
enum class SolveStrategy {
  newton,   ///< Newton's method from the predicted positions.
  descent,  ///< Energy minimization from the current positions.
};

/// An attempted step.
struct Step {
  Base base;
  SolveResult result;
};

/// Predicts the rod and solves for its equilibrium with the wall after a time step [s]. Needs
/// `work.section`. Afterwards positions, tracks and directions of curl are those of the end of the
/// step, all other parts of the state those of its start.
Step attemptStep(const InsertionModel& model, InsertionState& state, const Drive& drive,
                 double timeStep, SolveStrategy strategy, RodWorkspace& work) noexcept;

/// Makes the end of the attempted step the start of the next.
void commitStep(const InsertionModel& model, InsertionState& state,
                const RodWorkspace& work) noexcept;

/// Restores the state at the start of the attempted step.
void rollBackStep(InsertionState& state, RodWorkspace& work) noexcept;

}  // namespace perilymph::mechanics
