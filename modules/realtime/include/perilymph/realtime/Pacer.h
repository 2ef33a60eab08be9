#pragma once

// The beat of the haptic thread. The clock is read here and nowhere in the engine.

#include <cstdint>

#include "perilymph/foundation/RealTime.h"
#include "perilymph/foundation/Units.h"

namespace perilymph::realtime {

/// Time since an arbitrary start, never running backward [ns].
PERILYMPH_REALTIME std::int64_t monotonicNanoseconds() noexcept;

/// Wakes its thread at a fixed period.
///
/// A tick that is a little late leaves the grid as it is, so that the rate holds on average. A tick
/// more than `patience` periods late starts a new grid: the ticks between are counted as missed and
/// not made up for, because a burst of them would be motion no hand made.
class Pacer {
public:
  /// Periods by which a tick may be late before the grid is given up.
  static constexpr std::int64_t patience = 10;

  /// @throws std::invalid_argument for a period outside 10 us to 1 s.
  explicit Pacer(Duration period);

  /// Starts the grid: the first tick is due one period after `now` [ns].
  void start(std::int64_t now) noexcept;

  /// When the next tick is due [ns].
  std::int64_t due() const noexcept { return due_; }

  /// Counts a tick that begins at `now` [ns] and moves `due` on.
  PERILYMPH_REALTIME void begin(std::int64_t now) noexcept;

  /// Counts a tick that somebody else's clock began `now` [ns]; the grid goes on from it.
  PERILYMPH_REALTIME void follow(std::int64_t now) noexcept;

  /// Sleeps until the next tick is due, then begins it. Returns when that was [ns].
  std::int64_t wait() noexcept;

  /// Ticks that began more than one period late.
  std::uint64_t lateTicks() const noexcept { return lateTicks_; }
  /// Ticks of a given-up grid that never took place.
  std::uint64_t missedTicks() const noexcept { return missedTicks_; }

private:
  std::int64_t period_;  // [ns]
  std::int64_t due_ = 0;
  std::uint64_t lateTicks_ = 0;
  std::uint64_t missedTicks_ = 0;
};

}  // namespace perilymph::realtime
