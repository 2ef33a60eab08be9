// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Real-time scheduling priority of a thread, where the system grants it.

namespace perilymph::realtime {

/// Whether the system granted real-time priority.
enum class RealTimePriority { granted, refused };

/// Priority order of the program's own real-time threads.
enum class Rank {
  tick,   ///< The haptic thread.
  write,  ///< Threads that wait for a device on its behalf: lower priority.
};

/// Requests SCHED_FIFO for the calling thread, below the kernel's own threads (50) and above all
/// ordinary ones. Never fails: if refused, the thread keeps its priority.
RealTimePriority requestRealTimePriority(Rank rank = Rank::tick) noexcept;

}  // namespace perilymph::realtime
