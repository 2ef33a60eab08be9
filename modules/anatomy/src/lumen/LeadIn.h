#pragma once

// The joint of the straight lead-in and the spiral.

#include "perilymph/anatomy/ScalaTympani.h"

namespace perilymph::anatomy {

/// Bends the first degrees of a spiral so that every line of its wall leaves the round window along
/// the center line's tangent, as the straight lead-in does: the wall has no kink where they join.
///
/// The first section stays as it is; after `joint_deg` (12 degrees) all are as they were. Ours,
/// since no source says how the scala tympani opens; confidence low.
void easeIntoLeadIn(SectionTables& tables);

}  // namespace perilymph::anatomy
