#pragma once

// One time step of the published point set: what advance() does for a model of points.

#include "perilymph/foundation/RealTime.h"
#include "perilymph/mechanics/InsertionModel.h"
#include "perilymph/mechanics/InsertionState.h"
#include "points/PointWorkspace.h"

namespace perilymph::mechanics {

/// Puts the points where the state's nodes are: at rest on the carrier, their proxies inside the
/// surface. `state.points` is sized. Real-time safe.
PERILYMPH_REALTIME void resetPoints(const InsertionModel& model, InsertionState& state,
                                    PointWorkspace& workspace) noexcept;

/// Moves points, proxies and carrier one time step on, and fills what pictures and recordings read.
/// The same promises as advance(); no Newton iterations, so `residual` is 0 and `iterations` counts
/// equal steps within this one.
PERILYMPH_REALTIME void advancePoints(const InsertionModel& model, InsertionState& state,
                                      const Drive& drive, PointWorkspace& workspace) noexcept;

}  // namespace perilymph::mechanics
