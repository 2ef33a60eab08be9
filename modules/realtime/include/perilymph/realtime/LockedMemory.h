// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Memory that stays in RAM: a page that must be read from the disk first takes milliseconds.

#include <cstddef>
#include <span>

#include "perilymph/foundation/Sentence.h"

namespace perilymph::realtime {

/// What the system granted.
struct LockedMemory {
  bool isWhole = false;       ///< The whole process.
  std::size_t bytes = 0;      ///< Otherwise: of the requested buffers [bytes].
  std::size_t requested = 0;  ///< All of them [bytes].
  std::size_t limit = 0;      ///< RLIMIT_MEMLOCK [bytes].
  bool isComplete() const noexcept { return isWhole || bytes == requested; }
};

/// Locks all pages of the process that are in RAM, and others of its present mappings once they are
/// used, if the system permits; otherwise these buffers, in their order, as far as RLIMIT_MEMLOCK
/// allows. Stays in force until the process ends.
LockedMemory lockMemory(std::span<const std::span<const std::byte>> buffers) noexcept;

/// Writes to and locks the stack of the calling thread below the current frame, as far as a tick
/// reaches. False if the system does not lock it.
bool lockStack() noexcept;

/// A sentence that states what is not locked and what to do; empty if all is.
Sentence noteOn(const LockedMemory& locked);

}  // namespace perilymph::realtime
