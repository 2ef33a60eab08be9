#pragma once

// How evenly an array was pushed in: way and time at which speed, until the deepest place.

#include <optional>

#include "perilymph/foundation/Units.h"
#include "perilymph/haptics/Snapshot.h"

namespace perilymph::analysis {

/// The band of speeds: the slowest of a robot for insertions (iotaSOFT, 0.1 to 1.0 mm/s) to the
/// fastest of the published experiment and of measured phantoms (2.0 mm/s; Froehlich 2024).
inline constexpr Speed slowestSpeed = millimetersPerSecond(0.1);
inline constexpr Speed fastestSpeed = millimetersPerSecond(2.0);

/// Motion of the tip in stretches of 50 ms, from the first motion to the maximum travel.
struct Motion {
  double wayIn = 0.0;      ///< Sum of all stretches inward [m].
  double wayInBand = 0.0;  ///< Sum of those within the band of speeds [m].
  double time = 0.0;       ///< [s]
  double timeStill = 0.0;  ///< Slower than the band, whichever way [s].
  int reversals = 0;
};

/// Counts how often a motion turns round. A way back of less than 0.1 mm is trembling, not a
/// reversal.
class ReversalCounter {
public:
  /// @param travel  [m]
  void add(double travel);
  int reversals() const { return reversals_; }

private:
  double extreme_ = 0.0;  ///< The farthest in the present direction [m].
  int direction_ = 0;     ///< +1 in, -1 out, 0 not known yet.
  bool hasBegun_ = false;
  int reversals_ = 0;
};

/// Adds up a motion tick by tick, in their order.
class MotionCounter {
public:
  void add(const haptics::TickOutput& now);
  /// Up to the deepest place so far.
  const Motion& motion() const { return untilDeepest_; }

private:
  void endStretch(const haptics::TickOutput& now);

  ReversalCounter reversals_;
  std::optional<haptics::TickOutput> begin_;  ///< Begin of the stretch.
  Motion sofar_, untilDeepest_;
  double deepest_ = 0.0;  ///< Travel [m].
  bool hasMoved_ = false;
};

}  // namespace perilymph::analysis
