// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Period of the haptic thread. The engine reads the clock only here.

#include <cstdint>

#include "perilymph/foundation/Units.h"

namespace perilymph::realtime {

/// Time since an arbitrary start, never decreasing [ns].
std::int64_t monotonicNanoseconds() noexcept;

/// Wakes its thread at a fixed period.
///
/// A tick that is slightly late leaves the grid of due times unchanged, so that the mean rate is
/// kept. A tick more than `patience` periods late starts a new grid: the ticks between are counted
/// as missed and not made up for, because a burst of ticks would be motion the hand did not make.
class Pacer {
public:
  /// Maximum lateness of a tick before a new grid is started [periods].
  static constexpr std::int64_t patience = 10;

  /// @throws std::invalid_argument for a period outside 10 us to 1 s.
  explicit Pacer(Duration period);

  /// Starts the grid: the first tick is due one period after `now` [ns].
  void start(std::int64_t now) noexcept;

  /// When the next tick is due [ns].
  std::int64_t due() const noexcept { return due_; }

  /// Counts a tick that begins at `now` [ns] and advances due().
  void begin(std::int64_t now) noexcept;

  /// Counts a tick that an external clock began at `now` [ns]; the grid continues from there.
  void follow(std::int64_t now) noexcept;

  /// Sleeps until the next tick is due, then begins it. Returns the time at which it began [ns].
  std::int64_t wait() noexcept;

  /// Ticks that began more than one period late.
  std::uint64_t lateTicks() const noexcept { return lateTicks_; }
  /// Ticks of abandoned grids that never took place.
  std::uint64_t missedTicks() const noexcept { return missedTicks_; }

private:
  std::int64_t period_;  // [ns]
  std::int64_t due_ = 0;
  std::uint64_t lateTicks_ = 0;
  std::uint64_t missedTicks_ = 0;
};

}  // namespace perilymph::realtime
