// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Distribution of tick durations in constant memory.

#include <array>
#include <cstdint>

namespace perilymph::realtime {

/// Counts durations in fixed bins: exact below 32 ns, above that 32 bins per octave, so that a
/// quantile is at most 3.2 % above the true one. Single-threaded; real-time safe.
class TimeHistogram {
public:
  /// Counts one duration [ns]; negative values count as 0.
  void add(std::int64_t nanoseconds) noexcept;

  void clear() noexcept { *this = TimeHistogram(); }

  std::uint64_t count() const noexcept { return count_; }
  /// Maximum duration [s]; 0 if there is none.
  double longest() const noexcept { return static_cast<double>(longest_) * 1e-9; }

  /// Quantile of the durations [s], rounded up to the edge of its bin but never above the maximum;
  /// 0 if there is none.
  ///
  /// @param fraction  0 to 1; 0.5 gives the median.
  double quantile(double fraction) const noexcept;

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
