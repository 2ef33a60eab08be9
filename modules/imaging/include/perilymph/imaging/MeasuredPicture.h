// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// A picture of a measured cochlea in its CT, to check the measurement by eye.

#include <cstdint>
#include <filesystem>
#include <memory>
#include <vector>

#include "perilymph/ct/CtVolume.h"
#include "perilymph/ct/Measures.h"
#include "perilymph/foundation/Result.h"

namespace perilymph::imaging {

/// The picture as pixels.
struct RgbPicture {
  int width = 0, height = 0;
  std::vector<std::uint8_t> rgb;  ///< Three bytes a pixel, row by row from the top.
  double pixel_mm = 0.0;          ///< Edge of a pixel.
};

/// A picture of 1536 x 512 pixels, 32 pixels per millimeter: the cochlear view and the mid-modiolar
/// planes along A and along B, with the fitted wall, the lines of A, B and H, and a bar of 5 mm.
RgbPicture measuredPicture(std::shared_ptr<const ct::CtVolume> volume,
                           const ct::CochleaMeasures& measures);

/// Writes it as a PNG. Refuses another ending than .png.
Result<void> writeMeasuredPicture(std::shared_ptr<const ct::CtVolume> volume,
                                  const ct::CochleaMeasures& measures,
                                  const std::filesystem::path& file);

}  // namespace perilymph::imaging
