// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// What a plan's draws have in common, taken out of its bands: the friction, and, between two arrays, the
// whole ear and the hand.

#include <cstddef>
#include <vector>

#include "perilymph/planning/PlanResult.h"

namespace perilymph::planning {

/// Bands of one array's insertions at the median of the friction.
AtMedianFriction atMedianFriction(const std::vector<const PlannedInsertion*>& all);

/// The differences of every two of a plan's arrays.
///
/// @param insertions  By draw, then by array.
std::vector<ArrayDifference> differencesOf(std::size_t arrays,
                                           const std::vector<PlannedInsertion>& insertions);

}  // namespace perilymph::planning
