#pragma once

// One tick as bytes: what replay reads. Little-endian, field by field, no padding, so that -0.0,
// NaN and every last bit survive.

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "perilymph/haptics/Snapshot.h"

namespace perilymph::session {

/// First number of every blob.
inline constexpr std::uint32_t tickBlobVersion = 1;

/// Replaces `bytes` by the record's.
void writeTick(const haptics::TickRecord& record, std::vector<unsigned char>& bytes);

/// Nothing if the bytes are not those of a record of this version.
std::optional<haptics::TickRecord> readTick(std::span<const unsigned char> bytes);

}  // namespace perilymph::session
