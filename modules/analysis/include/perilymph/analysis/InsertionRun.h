// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// One insertion to its stop in virtual time, and what it gives for tables.

#include <filesystem>
#include <memory>
#include <stop_token>
#include <string>
#include <vector>

#include "perilymph/analysis/ContactPositions.h"
#include "perilymph/anatomy/ScalaTympani.h"
#include "perilymph/foundation/Result.h"
#include "perilymph/foundation/Units.h"
#include "perilymph/haptics/InsertionEnd.h"
#include "perilymph/session/InsertionParameters.h"
#include "perilymph/session/Scenario.h"

namespace perilymph::analysis {

using haptics::InsertionEnd;

/// Force at a depth of the tip.
struct DepthForce {
  Length depth;  ///< Past the opening.
  Force force;   ///< Axial, on the hand.
};

/// Result of an insertion.
struct InsertionRun {
  InsertionEnd end = InsertionEnd::refused;
  std::string reason;  ///< A message for a fault or a refusal; else empty.
  // The following values are those at the end, whatever it was; zero if refused.
  Length depth;           ///< Depth of the tip past the opening.
  Length maxDepth;        ///< Its maximum: of an array out of the opening, where it turned back.
  Angle apical;           ///< Angle of the most apical contact from the round window.
  Force endForce;         ///< StopForce over averaged().
  DepthForce peak;        ///< Maximum axial force, and where it first occurred.
  Force partition;        ///< Maximum force on the cochlear partition, within one contact.
  double coverage = 0.0;  ///< Part of the organ of Corti basal to the most apical contact.
  std::vector<ContactPosition> contacts;  ///< From the tip.
  std::vector<DepthForce> profile;        ///< At multiples of the spacing, first passage.
  std::uint64_t ticks = 0, ticksNotConverged = 0;
};

/// Pushes an array to its stop by a script at the given speed. Its tremor, seed and coupling are
/// those of the parameters.
///
/// @param anatomy         The cochlea of the parameters.
/// @param profileSpacing  Between points of the profile; 0: no profile.
/// @param stop            Ends the insertion early; the result is then meaningless.
InsertionRun runInsertion(const session::InsertionParameters& parameters,
                          std::shared_ptr<const anatomy::ScalaTympani> anatomy,
                          Length profileSpacing, const std::stop_token& stop);
/// The same insertion with a recording, without a profile. An error if it cannot be prepared or
/// recorded, or was ended early.
Result<InsertionRun> runInsertion(const session::Scenario& scenario,
                                  std::shared_ptr<const anatomy::ScalaTympani> anatomy,
                                  const std::filesystem::path& recording,
                                  const std::stop_token& stop);

}  // namespace perilymph::analysis
