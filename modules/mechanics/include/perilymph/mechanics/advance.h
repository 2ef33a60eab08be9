#pragma once

// The verb of the program: one time step of an insertion.

#include "perilymph/foundation/RealTime.h"
#include "perilymph/mechanics/InsertionModel.h"
#include "perilymph/mechanics/InsertionState.h"

namespace perilymph::mechanics {

/// Of Newton's method in one step: of the whole, and if that leaves too much, of each of its parts.
inline constexpr int mostIterations = 32;
inline constexpr int mostParts = 8;
/// Of the slower descent that follows where Newton's method leaves too much.
inline constexpr int mostDescents = 200;

/// Moves the state one time step on, by backward Euler: predict the rod, find contacts, solve
/// normal force and friction, read off the reaction at the base (into state.readings).
///
/// Where more than 1 mN is left unbalanced, as where an array snaps, the step is taken in parts of
/// equal time, with the hand on its way; the readings then hold the mean wrench on the hand.
///
/// Pure: no clock, no file, no randomness, bounded iterations. The same model, state and drive give
/// the same bits on every x86-64 machine. Real-time safe.
PERILYMPH_REALTIME void advance(const InsertionModel& model, InsertionState& state,
                                const Drive& drive) noexcept;

}  // namespace perilymph::mechanics
