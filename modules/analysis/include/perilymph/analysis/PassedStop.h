// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Where a hand that stops at a force would have ended an insertion that went on above it.

#include <cstddef>
#include <optional>

#include "perilymph/analysis/Surgeon.h"
#include "perilymph/anatomy/ScalaTympani.h"
#include "perilymph/electrode/ArrayDesign.h"
#include "perilymph/foundation/Units.h"
#include "perilymph/haptics/Snapshot.h"
#include "perilymph/session/InsertionParameters.h"

namespace perilymph::analysis {

/// The array at the first tick in which the axial force was above the force at which a hand stops.
struct PassedStop {
  Force stop;                            ///< At which the hand stops.
  Length depth;                          ///< Depth of the tip past the opening.
  Angle apical;                          ///< Angular insertion depth, as angularInsertionDepth().
  std::size_t inside = 0, contacts = 0;  ///< Contacts inside, and of the array.
};

/// The greatest force at which a hand of the plans stops: HandDistribution::stopHigh. Empty for an insertion
/// that itself stops at or below it.
std::optional<Force> stopToPass(const session::InsertionParameters& parameters,
                                const HandDistribution& hand);

/// @param at  The first tick for which haptics::raisesPeak() of `stop` is true.
PassedStop passedStop(const anatomy::ScalaTympani& scala, const electrode::ArrayDesign& array,
                      Force stop, const haptics::Snapshot& at);

}  // namespace perilymph::analysis
