// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The voxels of one DICOM file as Hounsfield units.

#include <cstdint>
#include <stop_token>
#include <vector>

#include "DicomHeader.h"
#include "perilymph/foundation/Result.h"

namespace perilymph::imaging {

/// Frames of one file one behind the other, rows from top to bottom.
struct DecodedFrames {
  std::vector<std::int16_t> voxels;
  std::size_t clipped = 0;  ///< Voxels beyond 16 bits.
  std::size_t padded = 0;  ///< Voxels that were not measured (PixelPaddingValue): `ct::unmeasured`.
};

/// Decodes a file and applies each frame's slope and intercept. Refuses a file that cannot be decoded, and voxels
/// that need more bits than the header says.
Result<DecodedFrames> decodeFrames(const DicomHeader& header, const std::stop_token& stop = {});

}  // namespace perilymph::imaging
