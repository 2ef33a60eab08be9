// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// One scripted insertion of a scenario, and what must hold of it, whatever its end.

#include <string>

#include "perilymph/haptics/InsertionEnd.h"
#include "perilymph/session/Scenario.h"

namespace perilymph::test {

/// Result of a run. SI units.
struct ScenarioRun {
  haptics::InsertionEnd end = haptics::InsertionEnd::none;
  std::string error;            ///< Message of a refusal or a fault; else empty.
  double peakForce = 0.0;       ///< Maximum magnitude of the force on the hand [N].
  double endForce = 0.0;        ///< Magnitude at the end [N].
  double work = 0.0;            ///< Work of the hand over the whole run [J].
  double deepest = 0.0;         ///< Maximum depth of the tip [m].
  double depth = 0.0;           ///< At the end [m].
  double angle = 0.0;           ///< Angular insertion depth at the end [rad].
  double lowestTweezers = 1.0;  ///< Minimum height of the tweezers above the opening's plane [m].
  double penetration = 0.0;     ///< Maximum depth of the array in bone [m].
  /// The same, less what the compliance of bone and membrane explains [m].
  double unexplained = 0.0;
  std::uint64_t ticks = 0;
  std::uint64_t ticksNotConverged = 0;
};

/// Direction in which the script pushes the array.
enum class Push { alongApproach, alongOpening };

/// Runs the scenario with its changed keys to its end.
ScenarioRun runScenario(const std::string& scenario, const session::Overrides& changes,
                        Push push = Push::alongApproach);

/// "array=flex28 ...", for messages.
std::string textOf(const session::Overrides& changes);

}  // namespace perilymph::test
