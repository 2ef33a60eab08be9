// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Transition from the straight lead-in to the spiral.

#include "perilymph/anatomy/ScalaTympani.h"

namespace perilymph::anatomy {

/// Bends the first degrees of a spiral so that every line of its wall leaves the round window along
/// the center line's tangent, as the straight lead-in does: the wall has no kink at the joint.
///
/// The first section and those after `joint_deg` (12 degrees) are unchanged. Our choice, since no
/// source describes the opening of the scala tympani; confidence low.
void easeIntoLeadIn(SectionTables& tables);

}  // namespace perilymph::anatomy
