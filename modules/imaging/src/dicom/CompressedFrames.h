// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Compressed voxels, decoded where a damaged file can do no harm.

#include <cstddef>
#include <functional>
#include <span>
#include <stop_token>

#include "DicomHeader.h"

namespace perilymph::imaging {

/// Voxels of one file up to which it is decoded.
inline constexpr std::size_t maxDecodedVoxels = 1'000'000'000;

/// How the decoded values are stored.
enum class StoredType { int8, uint8, int16, uint16, int32, uint32 };

/// Decodes a compressed file with GDCM in a process of its own: on files that are damaged or only
/// unusual, Debian's GDCM ends the process on an assertion, its decoders print, and some never come
/// to an end. `use` is given the decoded bytes, every frame behind the other.
///
/// @return  False where the file could not be decoded within a minute, or reading was canceled.
bool decodeCompressed(const DicomHeader& header, const std::stop_token& stop,
                      const std::function<void(StoredType, std::span<const std::byte>)>& use);

}  // namespace perilymph::imaging
