// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Newton's method for force equilibrium.

#include "solver/Residual.h"

namespace perilymph::mechanics {

/// Result of a step's iteration.
struct SolveResult {
  Residual residual;
  int iterations;
};

/// Moves the nodes from state.position_W until the forces are balanced: Newton's method with a line
/// search for lower energy. The factors of the stiffness are kept from step to step and renewed only
/// when they give bad steps. With the forces F_i on the nodes, the next motion d, the motion b of the
/// base and the names of SolverParameters, it stops if
///
///     max |F_i| and |sum F_i| <= forceTolerance  and  max |d_i| < max(motionTolerance, motionFraction b)
///     after an iteration with good factors:  the same forces  and  |d| < goodReduction times that
///     max |F_i| <= forceTolerance  and  max |d_i| < motionTolerance, after the first iteration
///     max |d_i| < stuck  and the iteration gained less than minGain, with factors of this step
///
/// or with the work that a step allows.
SolveResult solveNewton(const InsertionModel& model, InsertionState& state, const Base& base,
                        RodWorkspace& work) noexcept;

}  // namespace perilymph::mechanics
