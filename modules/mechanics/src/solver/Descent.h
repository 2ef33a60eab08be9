// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Energy minimization: slower than Newton's method, but globally convergent.

#include "solver/Newton.h"

namespace perilymph::mechanics {

/// Moves the nodes from state.position_W downhill in energy until the forces are balanced.
///
/// Every force in a step derives from an energy, including friction, because its bound is the
/// pressure of the previous step. Newton's direction with a positive definite matrix is a descent
/// direction; a line search finds a point along it where the directional derivative nearly
/// vanishes. This converges also where the residual first has to grow: where the array snaps, or
/// where contacts and friction toggle each other. Costs several residuals and one factorization per
/// iteration; gives up after maxDescentIterations.
///
/// @param settled  Result of the preceding iteration.
SolveResult minimizeEnergy(const InsertionModel& model, InsertionState& state, const Base& base,
                           SolveResult result, RodWorkspace& work) noexcept;

}  // namespace perilymph::mechanics
