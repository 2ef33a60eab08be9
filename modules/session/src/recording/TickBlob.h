// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Binary format of one tick, for replay. Little-endian, field by field, without padding, so that
// -0.0, NaN and every bit are preserved.

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "perilymph/haptics/Snapshot.h"

namespace perilymph::session {

/// First number in a blob: which fields it has beside those of the first version.
enum class TickBlobVersion : std::uint32_t {
  first = 1,          ///< None.
  ruptured = 2,       ///< Those of the rupture, in ticks after the cochlear partition ruptured.
  partition = 3,      ///< The force on the partition.
  partitionRuptured,  ///< Both.
  yielding,           ///< The force on the partition and the work of yielding.
  yieldingRuptured,   ///< All.
};

/// Encodes a record into `bytes`.
void writeTick(const haptics::TickRecord& record, std::vector<unsigned char>& bytes);

/// Empty if the bytes are not a record of this version.
std::optional<haptics::TickRecord> readTick(std::span<const unsigned char> bytes);

}  // namespace perilymph::session
