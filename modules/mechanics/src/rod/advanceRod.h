// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// One time step of the elastic rod: advance() for a rod model.

#include "perilymph/mechanics/InsertionModel.h"
#include "perilymph/mechanics/InsertionState.h"
#include "rod/RodWorkspace.h"

namespace perilymph::mechanics {

/// Advances the rod by one time step, as described at advance(). Real-time safe.
void advanceRod(const InsertionModel& model, InsertionState& state, const Drive& drive,
                RodWorkspace& work) noexcept;

}  // namespace perilymph::mechanics
