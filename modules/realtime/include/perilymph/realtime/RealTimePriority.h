#pragma once

// Going before everybody else on the machine, where the system allows it.

namespace perilymph::realtime {

/// Whether the system lets the calling thread go first.
enum class RealTimePriority { granted, refused };

/// Who of a program's own threads goes first.
enum class Rank {
  tick,   ///< The haptic thread.
  write,  ///< Those that wait for a device on its behalf: behind it.
};

/// Asks for SCHED_FIFO for the calling thread: below the kernel's own threads (50), above all
/// ordinary ones. Never fails: a refused thread goes on as it was.
RealTimePriority requestRealTimePriority(Rank rank = Rank::tick) noexcept;

}  // namespace perilymph::realtime
