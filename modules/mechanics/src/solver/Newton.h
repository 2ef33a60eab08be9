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
/// when they give bad steps (keptRatio). With the unbalanced forces F_i on the nodes, the motion d of the
/// iteration, the motion b of the base, s = max(motionTolerance, motionFraction b) and the names of
/// SolverParameters, it has converged if
///
///     max |F_i| <= atRest
///     max |F_i| and |sum F_i| <= forceTolerance  and  max |d_i| < s
///     the same forces, |F| reduced below goodRatio  and  max |d_i| < goodReduction s, of a motion made
///     max |F_i| <= forceTolerance  and  max |d_i| < motionTolerance, after the first iteration
///
/// In the second and the last of these cases d is left to the prediction of the next time step
/// (LinearSystem::stepRemains), since it is too short to be worth another evaluation.
///
/// |F_i| is the largest component and |F|^2 the sum of squares over all nodes. It also stops, and may
/// leave more than forceTolerance, if
///
///     max |d_i| < stuck, max |F_i| > forceTolerance  and  |F|^2 >= minGain times that before, of a
///         motion made, in a step that factorized the stiffness: the iteration makes no progress
///     d is no direction of descent (slope of the energy not positive) or not finite
///     the stiffness could not be factorized
///     the evaluations or factorizations that a step allows are used
SolveResult solveNewton(const InsertionModel& model, InsertionState& state, const Base& base,
                        RodWorkspace& work) noexcept;

}  // namespace perilymph::mechanics
