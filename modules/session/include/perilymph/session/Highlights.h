#pragma once

// An insertion in the few numbers a list of many shows.

#include <cstdint>

#include "perilymph/haptics/Snapshot.h"

namespace perilymph::session {

/// Highlights of an insertion since the array began to move; earlier ticks are only counted.
struct Highlights {
  std::uint64_t ticks = 0;
  double duration = 0.0;      ///< Since the array began to move, pauses included [s].
  double deepest = 0.0;       ///< Greatest depth past the opening [m].
  double deepestAngle = 0.0;  ///< Greatest angle of the tip from the round window [rad].
  double peakForce = 0.0;     ///< Greatest axial force on the hand [N].
  double peakTravel = 0.0;    ///< Where that was [m].
  double peakDepth = 0.0;     ///< [m]

  /// Adds one more tick, in their order.
  void add(const haptics::TickRecord& record) noexcept;

  friend bool operator==(const Highlights&, const Highlights&) = default;
};

}  // namespace perilymph::session
