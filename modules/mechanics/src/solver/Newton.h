#pragma once

// Newton's method for the balance of forces.

#include "solver/Residual.h"

namespace perilymph::mechanics {

// Below this a step is balanced.
inline constexpr double forceTolerance = 2e-6;  // [N]

/// How a step's iteration ended.
struct SolveResult {
  Residual residual;
  int iterations;
};

/// Moves the nodes from state.position_W until no force is left unbalanced: Newton's method with a
/// line search on the residual. The factors of the stiffness are kept from step to step and found
/// anew only where they do no longer serve. Stops where no force is above 2 uN and no node would
/// move by 0.2 nm, where contact toggles and nothing moves by 1 nm, or after maxIterations.
SolveResult solveNewton(const InsertionModel& model, InsertionState& state, const Base& base,
                        RodWorkspace& work) noexcept;

}  // namespace perilymph::mechanics
