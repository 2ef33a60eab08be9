#pragma once

// What a device's own count of reports tells: lost, repeated, overtaken and old ones.

#include <cstdint>
#include <limits>

#include "perilymph/foundation/RealTime.h"

namespace perilymph::device {

/// Follows a counter that grows by one with each report and may wrap at 8, 16 or 32 bits.
///
/// The age of a report follows from the counter and the clock: the offset between a report's time
/// of arrival and its count times the period is least for a report that never waited. By how much
/// another one's is above that, it is old. The least offset is let grow by 2 % of the time passed,
/// more than clocks of device and host can differ. A device that paused without counting is no
/// queue that waited: a report that came after the queue was seen empty is no older than that.
class ReportCount {
public:
  enum class Verdict : std::uint8_t { fresh, duplicate, old };

  /// @param period  Between reports [s].
  explicit ReportCount(double period) noexcept;

  /// No empty queue was seen yet.
  static constexpr std::int64_t never = std::numeric_limits<std::int64_t>::min();

  /// Judges a report that was taken `now` [ns], from a queue that was last seen empty at `emptyAt`
  /// [ns]. Real-time safe.
  PERILYMPH_REALTIME Verdict classify(std::uint64_t counter, std::int64_t now,
                                      std::int64_t emptyAt = never) noexcept;

  /// Reports missing just before the last fresh one.
  std::uint64_t lost() const noexcept { return lost_; }

  /// The device counts anew.
  PERILYMPH_REALTIME void startOver() noexcept;

private:
  std::int64_t period_;      // [ns]
  std::int64_t maxAge_;      // [ns]
  bool hasCounter_ = false;  // a counter other than 0 was seen
  std::uint64_t last_ = 0;
  std::int64_t reports_ = 0;  // by the counter, since the start, wraps unrolled
  std::int64_t minOffset_ = 0;
  std::int64_t lastTime_ = 0;
  std::uint64_t lost_ = 0;
};

}  // namespace perilymph::device
