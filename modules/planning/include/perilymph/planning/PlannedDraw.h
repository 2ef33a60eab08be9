// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// One draw of a plan, run again to be shown in full.

#include <cstddef>
#include <stop_token>

#include "perilymph/foundation/Result.h"
#include "perilymph/planning/PlanResult.h"
#include "perilymph/planning/PlannedShape.h"

namespace perilymph::planning {

/// The draw that represents an array: angle and peak force are nearest to their medians, in quartile
/// ranges. 0 if no draw could be run.
std::size_t medianDraw(const Plan& plan, std::size_t array);

/// Runs a plan's insertion again, to the same bits. Takes as long as one insertion and the building
/// of a cochlea.
///
/// @param array    Index into the plan's arrays.
/// @param draw     From 1, as in PlannedInsertion.
/// @param stop     Ends it early, with an error.
Result<PlannedShape> shapeOf(const Plan& plan, std::size_t array, std::size_t draw,
                             const std::stop_token& stop);

}  // namespace perilymph::planning
