// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// One time step of the published point set: advance() for a point-set model.

#include "perilymph/mechanics/InsertionModel.h"
#include "perilymph/mechanics/InsertionState.h"
#include "points/PointWorkspace.h"

namespace perilymph::mechanics {

/// Puts the points at the positions of the state's nodes: at rest on the carrier, their proxies
/// inside the surface. `state.points` must be sized. Real-time safe.
void resetPoints(const InsertionModel& model, InsertionState& state,
                 PointWorkspace& workspace) noexcept;

/// Advances points, proxies and carrier by one time step and fills the data read by snapshots and
/// recordings. Same guarantees as advance(); without Newton iterations, so `residual` is 0 and
/// `iterations` counts the substeps.
void advancePoints(const InsertionModel& model, InsertionState& state, const Drive& drive,
                   PointWorkspace& workspace) noexcept;

}  // namespace perilymph::mechanics
