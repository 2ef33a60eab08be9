#pragma once

// One step of time, or a part of one: tried, and then kept or undone.

#include "solver/Newton.h"

namespace perilymph::mechanics {

/// How a step is settled.
enum class SolveStrategy {
  newton,   ///< By Newton's method from where things would go by themselves.
  descent,  ///< By descent in energy from where they are.
};

/// A step that has been tried.
struct Step {
  Base base;
  SolveResult result;
};

/// Predicts the rod and settles it against the wall, a time [s] on. Needs `work.section`. The
/// state's positions, tracks and curls are those of the end of the step, the rest still that of its
/// start.
Step attemptStep(const InsertionModel& model, InsertionState& state, const Drive& drive,
                 double timeStep, SolveStrategy strategy, RodWorkspace& work) noexcept;

/// Makes the end of the step that was tried the start of the next.
void commitStep(InsertionState& state, const RodWorkspace& work) noexcept;

/// Back to where the step that was tried started.
void rollBackStep(InsertionState& state, RodWorkspace& work) noexcept;

}  // namespace perilymph::mechanics
