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

/// First number in a blob, and in one of a tick after the cochlear partition ruptured, which has more
/// fields.
inline constexpr std::uint32_t tickBlobVersion = 1, rupturedBlobVersion = 2;

/// Encodes a record into `bytes`.
void writeTick(const haptics::TickRecord& record, std::vector<unsigned char>& bytes);

/// Empty if the bytes are not a record of this version.
std::optional<haptics::TickRecord> readTick(std::span<const unsigned char> bytes);

}  // namespace perilymph::session
