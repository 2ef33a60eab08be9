// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The fragments of a compressed DICOM image.

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>

namespace perilymph::imaging {

/// What a file holds of a compressed image.
struct Fragments {
  std::size_t count = 0;    ///< Without the offset table.
  std::size_t offsets = 0;  ///< Frames that the offset table lists; 0 where it is empty.
  /// Fragments that begin an image of JPEG, JPEG-LS or JPEG 2000; none in run lengths.
  std::size_t starts = 0;
};

/// The fragments up to the delimiter that ends them; none where one is missing. Decoders fill what is missing with
/// gray and say nothing.
///
/// @param start  Byte at which the value of PixelData begins.
std::optional<Fragments> fragmentsOf(const std::filesystem::path& file, std::int64_t start);

}  // namespace perilymph::imaging
