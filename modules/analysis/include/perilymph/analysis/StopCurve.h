// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// An insertion by hand without a stop: how deep it would have ended at any force limit.

#include <memory>
#include <optional>
#include <stop_token>
#include <vector>

#include "perilymph/analysis/InsertionRun.h"
#include "perilymph/analysis/Surgeon.h"
#include "perilymph/anatomy/ScalaTympani.h"
#include "perilymph/foundation/Units.h"
#include "perilymph/haptics/InsertionEnd.h"
#include "perilymph/session/InsertionParameters.h"

namespace perilymph::analysis {

/// Force up to which a push without a stop is followed: twice the greatest force at which a surgeon is
/// said to stop (100 mN, resources/clinical/hand.toml), times 1.5 (choice, high).
inline constexpr Force highestStop = millinewtons(300);
/// Rise of the force between two points of a StopCurve at least: what a force limit is known to.
inline constexpr Force stopResolution = millinewtons(0.2);

/// A push to full depth that no surgeon's limit ended.
struct StopCurve {
  /// Depth and axial force wherever the force first rose above its former maximum; forces ascend. Ticks
  /// out of balance are left out, as in insertByHand().
  std::vector<DepthForce> rises;
  /// haptics::InsertionEnd::finished at full depth; stoppedByResistance at highestStop.
  haptics::InsertionEnd end = haptics::InsertionEnd::refused;
  Length depth;  ///< At the end, past the opening.

  /// Depth of the tip at which the force first reaches a limit; absent if it stays below. A limit above
  /// highestStop is never reached.
  std::optional<Length> lengthAt(Force limit) const;
};

/// The push of insertByHand() with the same motion, without the surgeon's limits of force and depth and
/// without the rest. The end is `refused` if it cannot be prepared; the parameters are those of
/// insertByHand(). `stop` ends it early; the result is then meaningless.
StopCurve pushWithoutStop(const session::InsertionParameters& nominal,
                          std::shared_ptr<const anatomy::ScalaTympani> anatomy,
                          const HandDistribution& hand, const Surgeon& surgeon,
                          const std::stop_token& stop);

}  // namespace perilymph::analysis
