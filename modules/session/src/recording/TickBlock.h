// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Ticks packed without loss, as a recording stores them: one row of the table `block`.
//
//   1. Every field of a tick is a column of 64-bit numbers: the bits of a double, or an integer.
//   2. A column becomes the differences of its numbers, modulo 2^64, to what is predicted: the number
//      before, or the line through the two before; or, for columns that others imply (the depth by the
//      travel, the axial force by its components, the commanded position by the hand's), a linear
//      function of these, found by least squares. That which leaves the fewest bits is used.
//   3. The sign moves to the lowest bit, and bytes of equal weight follow each other: those that are
//      always 0 are long runs.
//   4. Zstandard compresses the whole: a coding for each column, the coefficients, the columns, and the
//      commands of the ticks (kind, bits of the value).

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "perilymph/foundation/Sha256.h"
#include "perilymph/haptics/Snapshot.h"
#include "perilymph/session/Recording.h"

namespace perilymph::session {

/// Packs ticks; keeps its memory between calls.
class BlockPacker {
public:
  BlockPacker();
  ~BlockPacker();
  BlockPacker(BlockPacker&&) noexcept;
  BlockPacker& operator=(BlockPacker&&) noexcept;

  /// The packed bytes of 1 to blockTicks ticks, valid until the next call; empty without memory.
  std::span<const unsigned char> pack(std::span<const haptics::TickRecord> records);

private:
  struct Content;
  std::unique_ptr<Content> content_;
};

/// Unpacks blocks of untrusted files; keeps its memory between calls.
class BlockUnpacker {
public:
  BlockUnpacker();
  ~BlockUnpacker();
  BlockUnpacker(BlockUnpacker&&) noexcept;
  BlockUnpacker& operator=(BlockUnpacker&&) noexcept;

  /// The ticks, valid until the next call; empty if the bytes are not those of this many ticks in
  /// increasing order.
  std::span<const haptics::TickRecord> unpack(std::span<const unsigned char> packed,
                                              std::uint64_t ticks);

private:
  struct Content;
  std::unique_ptr<Content> content_;
};

/// Adds a row of the table `block` to the hash of a recording.
void addBlock(Sha256& hash, std::int64_t firstTick, std::int64_t ticks,
              std::span<const unsigned char> packed);

}  // namespace perilymph::session
