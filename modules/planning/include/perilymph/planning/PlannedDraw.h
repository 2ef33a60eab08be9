// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The draws that represent the arrays of a plan, run again to be shown in full.

#include <array>
#include <cstddef>
#include <stop_token>
#include <vector>

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

/// An array at the end of the draw that represents it.
struct RepresentativeEnd {
  std::size_t draw = 0;                      ///< 0 if no draw could be run.
  std::vector<std::array<float, 3>> node_W;  ///< From the base to the tip [m].
};

/// The ends of all arrays of a plan, as shapeOf() gives them. Those of a plan that was just made are
/// kept with its insertions; those of insertions read from a file are run again, in parallel, arrays
/// of the same draw in one cochlea.
///
/// @param stop  Ends it early, with an error.
Result<std::vector<RepresentativeEnd>> representativeEnds(const Plan& plan,
                                                          const std::stop_token& stop);

}  // namespace perilymph::planning
