// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// A picture of a measured cochlea in its CT, to check the measurement by eye.

#include <filesystem>
#include <memory>

#include "perilymph/ct/CtVolume.h"
#include "perilymph/ct/Measures.h"
#include "perilymph/foundation/Result.h"

namespace perilymph::imaging {

/// Writes a PNG of 1536 x 512 pixels, 32 pixels per millimeter: the cochlear view and the
/// mid-modiolar planes along A and along B, with the fitted wall, the lines of A, B and H, and a bar
/// of 5 mm.
Result<Done> writeMeasuredPicture(std::shared_ptr<const ct::CtVolume> volume,
                                  const ct::CochleaMeasures& measures,
                                  const std::filesystem::path& file);

}  // namespace perilymph::imaging
