// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// One insertion by a script as the command `simulate` runs it, and what it says of it.

#include <functional>
#include <optional>
#include <string>

#include "perilymph/analysis/ForceProfile.h"
#include "perilymph/analysis/PassedStop.h"
#include "perilymph/foundation/Result.h"
#include "perilymph/haptics/HapticLoop.h"
#include "perilymph/session/Insertion.h"
#include "perilymph/session/Scenario.h"

namespace perilymph::analysis {

/// Result of an insertion by a script.
struct SimulatedInsertion {
  ForceProfile profile;
  haptics::TickOutput last;
  Angle angularInsertionDepth;           ///< At the end; 0 if no contact is inserted.
  std::optional<PassedStop> passedStop;  ///< Empty if the force stayed below, see stopToPass().
};

/// Runs a prepared insertion to its end in virtual time.
///
/// @param each  Receives every tick; returns false to stop, which is an error.
/// @return      An error if it stopped with a fault, or if the tip did not enter the opening: there
///              is nothing to report then.
Result<SimulatedInsertion> simulate(session::Insertion& insertion,
                                    const std::function<bool(const haptics::TickRecord&)>& each);

/// "at 9.31 mm of depth, 2.013 N on the hand".
std::string placeOf(const haptics::TickOutput& now);

/// The scenario as run and its results, as JSON: versions, key figures with their units, the end.
std::string simulationJson(const session::Scenario& scenario, const SimulatedInsertion& simulated,
                           const haptics::LoopStatistics& statistics);

}  // namespace perilymph::analysis
