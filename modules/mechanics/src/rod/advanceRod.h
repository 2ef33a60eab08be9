#pragma once

// One time step of the elastic rod: what advance() does for a model of a rod.

#include "perilymph/foundation/RealTime.h"
#include "perilymph/mechanics/InsertionModel.h"
#include "perilymph/mechanics/InsertionState.h"
#include "rod/RodWorkspace.h"

namespace perilymph::mechanics {

/// Moves the rod one time step on, as advance() describes it. Real-time safe.
PERILYMPH_REALTIME void advanceRod(const InsertionModel& model, InsertionState& state,
                                   const Drive& drive, RodWorkspace& work) noexcept;

}  // namespace perilymph::mechanics
