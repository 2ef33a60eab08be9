// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Key figures of an insertion, for lists.

#include <cstdint>

#include "perilymph/haptics/InsertionEnd.h"
#include "perilymph/haptics/Snapshot.h"

namespace perilymph::session {

/// Key figures since the array began to move; earlier ticks are only counted.
struct Highlights {
  std::uint64_t ticks = 0;
  double duration = 0.0;      ///< From the first to the last motion, pauses included [s].
  double deepest = 0.0;       ///< Maximum depth past the opening [m].
  double deepestAngle = 0.0;  ///< Maximum angle of the tip from the round window [rad].
  double peakForce = 0.0;     ///< Maximum axial force on the hand [N].
  double peakTravel = 0.0;    ///< Travel at that force [m].
  double peakDepth = 0.0;     ///< [m]
  haptics::InsertionEnd end =
      haptics::InsertionEnd::none;  ///< The first end other than finished, if any.
  bool hasBegun = false;            ///< There was a tick after the first motion.
  bool isMoving = false;            ///< The hand moved the array in the last tick.

  /// Adds the next tick.
  void add(const haptics::TickRecord& record) noexcept;

  /// Compares the key figures.
  friend bool operator==(const Highlights& a, const Highlights& b) noexcept
  {
    return a.ticks == b.ticks && a.duration == b.duration && a.deepest == b.deepest &&
           a.deepestAngle == b.deepestAngle && a.peakForce == b.peakForce &&
           a.peakTravel == b.peakTravel && a.peakDepth == b.peakDepth && a.end == b.end;
  }
};

}  // namespace perilymph::session
