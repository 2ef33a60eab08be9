// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// A picture of a measured cochlea in its CT, to check the measurement by eye.

#include <Eigen/Core>
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
///
/// @param contacts_P  Contacts of an array, the most apical first: rings, the first with a cross; in the
///                    mid-modiolar planes those within 0.6 mm. With contacts A, B and H are not drawn.
RgbPicture measuredPicture(std::shared_ptr<const ct::CtVolume> volume,
                           const ct::CochleaMeasures& measures,
                           const std::vector<Eigen::Vector3d>& contacts_P = {});

/// Writes it as a PNG. Refuses another ending than .png.
Result<void> writeMeasuredPicture(std::shared_ptr<const ct::CtVolume> volume,
                                  const ct::CochleaMeasures& measures,
                                  const std::filesystem::path& file,
                                  const std::vector<Eigen::Vector3d>& contacts_P = {});

}  // namespace perilymph::imaging
