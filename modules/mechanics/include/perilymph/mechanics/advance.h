#pragma once

// The verb of the program: one time step of an insertion.

#include "perilymph/foundation/RealTime.h"
#include "perilymph/mechanics/InsertionModel.h"
#include "perilymph/mechanics/InsertionState.h"

namespace perilymph::mechanics {

/// Maximum Newton iterations per time step.
inline constexpr int maxIterations = 32;
/// In which a step is taken that does not settle as a whole.
inline constexpr int maxSubsteps = 8;
/// Maximum iterations of the energy minimization per time step, and per substep.
inline constexpr int maxDescentIterations = 200;

/// Moves the state one time step on, by backward Euler: predict the rod, find contacts, solve
/// normal force and friction, read off the reaction at the base (into state.readings).
///
/// Where Newton's method leaves more than 2 uN unbalanced, a descent in energy goes on; where it
/// leaves more than 1 mN, as where an array snaps, the descent starts anew from where the array
/// was. If that, too, leaves more, the step is taken in parts of equal time, with the hand on its
/// way; the readings then hold the mean wrench on the hand.
///
/// Pure: no clock, no file, no randomness, bounded iterations. The same model, state and drive give
/// the same bits on every x86-64 machine. Real-time safe.
PERILYMPH_REALTIME void advance(const InsertionModel& model, InsertionState& state,
                                const Drive& drive) noexcept;

}  // namespace perilymph::mechanics
