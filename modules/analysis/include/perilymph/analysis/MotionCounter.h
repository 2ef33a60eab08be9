// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Smoothness of an insertion: distance and time by speed, up to the maximum depth.

#include <optional>

#include "perilymph/foundation/Units.h"
#include "perilymph/haptics/Snapshot.h"

namespace perilymph::analysis {

/// The speed range: from the minimum of an insertion robot (iotaSOFT, 0.1 to 1.0 mm/s) to the
/// maximum of the published experiment and of measured phantoms (2.0 mm/s; Froehlich 2024).
inline constexpr Speed slowestSpeed = millimetersPerSecond(0.1);
inline constexpr Speed fastestSpeed = millimetersPerSecond(2.0);

/// Motion in intervals of 50 ms, from the first motion to the maximum travel. Distances are those of
/// the tip. Speeds are those of the hand along its path: between hand and array a spring gives way
/// and springs back, so that even the tip of a hand at constant speed is not at constant speed. Time
/// at full depth does not count.
struct Motion {
  double wayIn = 0.0;      ///< Sum of all inward motion [m].
  double wayInBand = 0.0;  ///< Inward motion within the speed range [m].
  /// Inward motion, outside the range by its speed over slowestSpeed or by fastestSpeed over its speed [m].
  double wayBySpeed = 0.0;
  double time = 0.0;       ///< [s]
  double timeStill = 0.0;  ///< Slower than the range, in either direction [s].
  int reversals = 0;       ///< Withdrawals of 0.1 mm or more.

  /// Inward motion by its time, pauses included [m/s]; 0 without motion.
  double meanSpeed() const { return time > 0.0 ? wayIn / time : 0.0; }
};

/// Counts reversals of a motion: withdrawals of 0.1 mm or more after an advance. Less is tremor; a further advance is none.
class ReversalCounter {
public:
  /// @param travel  [m]
  void add(double travel);
  int reversals() const { return reversals_; }

private:
  double extreme_ = 0.0;  ///< Extreme travel in the current direction [m].
  int direction_ = 0;     ///< +1 in, -1 out, 0 unknown.
  bool hasBegun_ = false;
  int reversals_ = 0;
};

/// Accumulates a motion tick by tick, in order.
class MotionCounter {
public:
  void add(const haptics::TickOutput& now);
  /// Up to the maximum depth so far.
  const Motion& motion() const { return untilDeepest_; }

private:
  void endStretch(const haptics::TickOutput& now);
  double wayOfHand(const haptics::TickOutput& now) const;

  ReversalCounter reversals_;
  std::optional<haptics::TickOutput> first_;  ///< First tick of the insertion.
  std::optional<haptics::TickOutput> begin_;  ///< Begin of the interval.
  Motion sofar_, untilDeepest_;
  double deepest_ = 0.0;  ///< Travel [m].
  bool hasMoved_ = false;
};

}  // namespace perilymph::analysis
