// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// One insertion of a plan, run again for a view: its cochlea, its array at the end, its force.

#include <memory>

#include "perilymph/anatomy/ScalaTympani.h"
#include "perilymph/foundation/FieldMeaning.h"
#include "perilymph/foundation/Result.h"
#include "perilymph/haptics/Snapshot.h"
#include "perilymph/planning/PlanResult.h"
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

/// Columns of a table of planned shapes, a row per node from the base to the tip.
const FieldMeanings& shapeColumns();

}  // namespace perilymph::planning
