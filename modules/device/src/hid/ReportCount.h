// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Evaluation of a device's report counter: lost, repeated, reordered and old reports.

#include <cstdint>
#include <limits>

namespace perilymph::device {

/// Tracks a counter that increments with each report and may wrap at 8, 16 or 32 bits.
///
/// The age of a report follows from the counter and the clock: the offset between its arrival time
/// and its count times the period is smallest for a report that never waited. The excess over that
/// minimum is the report's age. The minimum may grow by 2 % of the elapsed time, more than the
/// clocks of device and host can differ. A device that paused without counting must not look like a
/// queue that waited: a report that arrived after the queue was seen empty is no older than that.
class ReportCount {
public:
  enum class Verdict : std::uint8_t { fresh, duplicate, old };

  /// @param period  Between reports [s].
  explicit ReportCount(double period) noexcept;

  /// No empty queue was seen yet.
  static constexpr std::int64_t never = std::numeric_limits<std::int64_t>::min();

  /// Classifies a report that was taken at `now` [ns] from a queue that was last seen empty at
  /// `emptyAt` [ns]. Real-time safe.
  Verdict classify(std::uint64_t counter, std::int64_t now, std::int64_t emptyAt = never) noexcept;

  /// Number of reports missing before the last fresh one.
  std::uint64_t lost() const noexcept { return lost_; }

  /// Restarts after the device restarted its counter.
  void reset() noexcept;

private:
  std::int64_t period_;      // [ns]
  std::int64_t maxAge_;      // [ns]
  bool hasCounter_ = false;  // a nonzero counter was seen
  std::uint64_t last_ = 0;
  std::int64_t reports_ = 0;  // number of reports since the start, by the counter, wraps unrolled
  std::int64_t minOffset_ = 0;
  std::int64_t lastTime_ = 0;
  std::uint64_t lost_ = 0;
};

}  // namespace perilymph::device
