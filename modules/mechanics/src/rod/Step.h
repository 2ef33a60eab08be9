// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// One time step: taken, then committed.

#include "solver/Newton.h"

namespace perilymph::mechanics {

/// A step whose forces are balanced, or that is continued in the next one.
struct Step {
  Base base;
  SolveResult result;
};

/// Predicts the rod and solves for its equilibrium with the wall after a time step. Needs
/// `work.section`. Afterwards positions, tracks and directions of curl are those of the end of the
/// step, all other parts of the state those of its start.
///
/// @param styletMoved  Motion of the stylet in this step, out of the array [m].
Step takeStep(const InsertionModel& model, InsertionState& state, const Drive& drive,
              double styletMoved, RodWorkspace& work) noexcept;

/// Makes the end of the step the start of the next; without momentum if state.isSettling.
void commitStep(const InsertionModel& model, InsertionState& state, RodWorkspace& work) noexcept;

}  // namespace perilymph::mechanics
