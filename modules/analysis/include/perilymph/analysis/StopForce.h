// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The force with which an insertion ends.

#include <deque>
#include <optional>

#include "perilymph/foundation/Units.h"
#include "perilymph/haptics/Snapshot.h"

namespace perilymph::analysis {

/// The axial force on the hand at its stop: the end of the straight line (least squares) through the
/// force over the last moments of motion. Pauses are not counted. It is the mean of a steady force
/// with tremor, and does not lag behind a rising one, as a mean does: over 0.5 s by half the rise.
class StopForce {
public:
  /// @param window  Time in motion that the line goes through.
  explicit StopForce(Duration window) : window_(window.si()) {}

  /// Takes the next tick, in order.
  void add(const haptics::TickOutput& now);
  /// The force at the last motion so far [N]; 0 without a motion.
  double value() const;

private:
  struct Point {
    double time, force;  ///< In motion [s]; [N].
  };

  double window_;
  double inMotion_ = 0.0;   ///< Time in motion so far [s].
  std::deque<Point> last_;  ///< The points within the window.
  std::optional<haptics::TickOutput> before_;
};

}  // namespace perilymph::analysis
