#pragma once

// Which nodes can touch the wall at all.

#include "contact/ContactSet.h"
#include "perilymph/mechanics/InsertionModel.h"
#include "perilymph/mechanics/InsertionState.h"
#include "rod/RodKinematics.h"

namespace perilymph::mechanics {

/// Asks the lumen for the wall at every node that can have come near it, into contacts.wall.
///
/// No node's distance to the wall changes by more than the node moves. A node that was seen far
/// from it is not asked for again before it has moved as far as that; nothing is approximated.
void findWall(const InsertionModel& model, const StepStart& start, InsertionState& state,
              ContactSet& contacts) noexcept;

/// Which nodes stand over bone at the start of a step, more than their radius beside the opening,
/// or have slid there just below its plane: they cannot come in, and meet that plane where they
/// try. None is let go inside bone, so that this takes energy at most.
void findBone(const InsertionModel& model, InsertionState& state) noexcept;

/// Brings state.clearance up to date at the end of a step.
void keepClearance(const StepStart& start, const ContactSet& contacts,
                   InsertionState& state) noexcept;

}  // namespace perilymph::mechanics
