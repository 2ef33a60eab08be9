#pragma once

// How long ticks took, without keeping every one of them.

#include <array>
#include <cstdint>

#include "perilymph/foundation/RealTime.h"

namespace perilymph::realtime {

/// Counts durations in fixed bins: exact below 32 ns, above that 32 bins an octave, so that a
/// quantile is at most 3.2 % above the true one. One thread; real-time safe.
class TimeHistogram {
public:
  /// Counts one duration [ns]; negative ones count as 0.
  PERILYMPH_REALTIME void add(std::int64_t nanoseconds) noexcept;

  PERILYMPH_REALTIME void clear() noexcept { *this = TimeHistogram(); }

  std::uint64_t count() const noexcept { return count_; }
  /// The longest duration [s]; 0 without any.
  double longest() const noexcept { return static_cast<double>(longest_) * 1e-9; }

  /// The duration that a share of all do not exceed [s], rounded up to its bin's edge but never
  /// above the longest; 0 without any.
  ///
  /// @param share  0 to 1; 0.5 gives the median.
  PERILYMPH_REALTIME double quantile(double fraction) const noexcept;

private:
  static constexpr int binsPerOctave = 32;
  static constexpr int octaves = 36;  // up to 32 ns 2^36, about 37 minutes

  static int binOf(std::uint64_t nanoseconds) noexcept;
  static std::uint64_t upperEdge(int bin) noexcept;

  std::array<std::uint32_t, binsPerOctave * octaves> bins_{};
  std::uint64_t count_ = 0;
  std::uint64_t longest_ = 0;
};

}  // namespace perilymph::realtime
