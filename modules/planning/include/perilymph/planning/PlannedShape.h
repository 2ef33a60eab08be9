// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// One insertion of a plan, run again for a view: its cochlea, its array at the end, its force.

#include <memory>
#include <stop_token>

#include "perilymph/anatomy/ScalaTympani.h"
#include "perilymph/foundation/Result.h"
#include "perilymph/haptics/Snapshot.h"
#include "perilymph/planning/Plan.h"
#include "perilymph/session/InsertionParameters.h"

namespace perilymph::planning {

/// Distance between the points of PlannedShape's force profile.
inline constexpr Length traceSpacing = millimeters(0.1);

/// An insertion with everything that a view shows.
struct PlannedShape {
  session::InsertionParameters parameters;  ///< As run, but for the hand: `array`, `cochlea`, ...
  std::shared_ptr<const anatomy::ScalaTympani> anatomy;  ///< The draw's cochlea.
  haptics::Snapshot end;                                 ///< The array at the end.
  PlannedInsertion insertion;  ///< The plan's; the profile at `traceSpacing`.
};

/// The draw that represents an array: angle and peak force are nearest to their medians, in quartile
/// ranges. 0 if no draw could be run.
std::size_t medianDraw(const Plan& plan, std::size_t array);

/// Runs a plan's insertion again, to the same bits. Takes as long as one insertion and the building
/// of a cochlea.
///
/// @param array    Index into the plan's arrays.
/// @param draw     From 1, as in PlannedInsertion.
/// @param stop  Ends it early, with an error.
Result<PlannedShape> shapeOf(const Plan& plan, std::size_t array, std::size_t draw,
                             const std::stop_token& stop);

}  // namespace perilymph::planning
