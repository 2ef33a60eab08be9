// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Contact of nodes in and above an open part of the cochlear partition.

#include "contact/ContactSet.h"
#include "perilymph/mechanics/InsertionModel.h"
#include "perilymph/mechanics/InsertionState.h"
#include "rod/RodKinematics.h"

namespace perilymph::mechanics {

/// Determines at the start of a step which nodes are in an open part of the partition or above it.
/// There a node takes the side whose wall is farther away, which never adds energy; elsewhere it
/// keeps its side.
void findSides(const InsertionModel& model, InsertionState& state, ContactSet& contacts) noexcept;

/// Normal force of both scalae and the partition on such a node, and its stiffness. False if nothing
/// touches it.
bool openContact(const InsertionModel& model, InsertionState& state, const RodKinematics& rod,
                 std::size_t i, ContactSet& contacts) noexcept;

}  // namespace perilymph::mechanics
