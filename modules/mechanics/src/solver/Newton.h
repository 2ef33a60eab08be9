// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Newton's method for force equilibrium.

#include "solver/Residual.h"

namespace perilymph::mechanics {

// Residual below which a step is converged.
inline constexpr double forceTolerance = 2e-6;  // [N]

/// Result of a step's iteration.
struct SolveResult {
  Residual residual;
  int iterations;
};

/// Moves the nodes from state.position_W until the forces are balanced: Newton's method with a line
/// search for lower energy. The factors of the stiffness are kept from step to step and renewed only
/// when they give bad steps. Stops if no force exceeds 2 uN, nor their sum, and no node would
/// move by 0.2 nm or by a thousandth of the motion of the base, which after a short step with good
/// factors is taken for granted; if contact toggles and nothing moves by 1 nm; or with the work that
/// a step allows.
SolveResult solveNewton(const InsertionModel& model, InsertionState& state, const Base& base,
                        RodWorkspace& work) noexcept;

}  // namespace perilymph::mechanics
