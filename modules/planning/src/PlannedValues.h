// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// What summaries read of a planned insertion, in the units of the bands.

#include "perilymph/planning/PlanResult.h"

namespace perilymph::planning {

/// An insertion that could not be prepared has an end and no values.
inline bool isRun(const PlannedInsertion& each)
{
  return each.insertion.end != haptics::InsertionEnd::refused;
}
inline double angleOf(const PlannedInsertion& each) { return inDegrees(each.insertion.apical); }
inline double depthOf(const PlannedInsertion& each) { return inMillimeters(each.insertion.depth); }
inline double peakOf(const PlannedInsertion& each) { return inMillinewtons(each.insertion.peak); }
inline double endOf(const PlannedInsertion& each)
{
  return inMillinewtons(each.insertion.endForce);
}

}  // namespace perilymph::planning
