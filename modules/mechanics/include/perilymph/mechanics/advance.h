// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// One time step of an insertion.

#include "perilymph/foundation/RealTime.h"
#include "perilymph/mechanics/InsertionModel.h"
#include "perilymph/mechanics/InsertionState.h"

namespace perilymph::mechanics {

/// Maximum Newton iterations per time step.
inline constexpr int maxIterations = 32;
/// Maximum number of substeps into which a step that does not converge is divided.
inline constexpr int maxSubsteps = 8;
/// Maximum iterations of the energy minimization per time step, and per substep.
inline constexpr int maxDescentIterations = 200;

/// Advances the state by one time step of backward Euler: predicts the rod, finds contacts, solves
/// for normal force and friction, and computes the reaction at the base (into state.readings).
///
/// If Newton's method leaves a residual of more than 2 uN, an energy minimization continues from
/// there; if more than 1 mN, as when an array snaps, the step is rolled back and the minimization
/// starts from its beginning. If more than 1 mN still remains, the step is divided into equal
/// substeps, with the hand interpolated; the readings then contain the mean wrench on the hand.
///
/// Pure: no clock, no file, no randomness, bounded iterations. The same model, state and drive give
/// the same bits on every x86-64 machine. Real-time safe.
PERILYMPH_REALTIME void advance(const InsertionModel& model, InsertionState& state,
                                const Drive& drive) noexcept;

}  // namespace perilymph::mechanics
