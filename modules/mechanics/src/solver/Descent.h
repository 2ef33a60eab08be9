#pragma once

// The slow and certain way to the balance of forces.

#include "solver/Newton.h"

namespace perilymph::mechanics {

/// Moves the nodes from state.position_W downhill in energy until no force is left unbalanced.
///
/// Every force of a step is that of an energy: friction's, too, for its bound is the pressure of
/// the step before. Newton's direction with a positive matrix goes downhill; along it the place is
/// sought where forces hardly pull on any more. That ends in a balance also where the residual
/// first has to grow: where the array snaps, or where contacts and friction toggle each other.
/// Costs several balances and one factorization an iteration; after maxDescentIterations it gives up.
///
/// @param settled  How the iteration before ended.
SolveResult minimizeEnergy(const InsertionModel& model, InsertionState& state, const Base& base,
                           SolveResult result, RodWorkspace& work) noexcept;

}  // namespace perilymph::mechanics
