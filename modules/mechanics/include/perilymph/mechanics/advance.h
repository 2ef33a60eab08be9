// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// One time step of an insertion.

#include "perilymph/foundation/RealTime.h"
#include "perilymph/mechanics/InsertionModel.h"
#include "perilymph/mechanics/InsertionState.h"

namespace perilymph::mechanics {

/// Maximum evaluations of all forces in a time step.
inline constexpr int maxEvaluations = 32;
/// Maximum factorizations of the stiffness in a time step.
inline constexpr int maxFactorizations = 10;

/// Advances the state by one time step of backward Euler: predicts the rod, finds contacts, solves
/// for normal force and friction, and computes the reaction at the base (into state.readings).
///
/// Every iteration lowers the energy, until no force exceeds 2 uN. The work is bounded: a step that
/// still has more than 0.1 mN, as when an array snaps, goes on in the next one, from where it is and
/// without momentum (state.isSettling). Meanwhile the readings hold the gradient of the energy where
/// the array is.
///
/// Pure: no clock, no file, no randomness, bounded work. The same model, state and drive give the
/// same bits on every x86-64 machine. Real-time safe.
PERILYMPH_REALTIME void advance(const InsertionModel& model, InsertionState& state,
                                const Drive& drive) noexcept;

}  // namespace perilymph::mechanics
