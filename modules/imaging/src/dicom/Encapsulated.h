// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Whether the fragments of a compressed DICOM image are all there.

#include <cstdint>
#include <filesystem>

namespace perilymph::imaging {

/// True where the file holds every fragment of its compressed image, up to the delimiter that ends
/// them. Decoders fill what is missing with gray and say nothing.
///
/// @param start  Byte at which the value of PixelData begins.
bool hasAllFragments(const std::filesystem::path& file, std::int64_t start);

}  // namespace perilymph::imaging
