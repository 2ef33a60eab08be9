// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Selection of the nodes that can touch the wall.

#include "contact/ContactSet.h"
#include "perilymph/mechanics/InsertionModel.h"
#include "perilymph/mechanics/InsertionState.h"
#include "rod/RodKinematics.h"

namespace perilymph::mechanics {

/// Queries the lumen for the wall at every node that may be near it, into contacts.wall.
///
/// The distance of a node to the wall changes by no more than the node moves. A node found far from
/// the wall is not queried again until it has moved that far; this is exact.
void findWall(const InsertionModel& model, const StepStart& start, InsertionState& state,
              ContactSet& contacts) noexcept;

/// Determines which nodes are over bone at the start of a step, more than their radius beside the
/// opening, or have slid there just below its plane: they cannot enter and touch that plane
/// instead. No node is released inside bone, so that this never adds energy.
void findBone(const InsertionModel& model, InsertionState& state, ContactSet& contacts) noexcept;

/// Updates state.clearance at the end of a step, where findWall() was called last.
void keepClearance(ContactSet& contacts, InsertionState& state) noexcept;

}  // namespace perilymph::mechanics
