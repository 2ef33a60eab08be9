// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Writes a print figure as a PNG file, without display or OpenGL.

#include <filesystem>

#include "perilymph/figures/Drawing.h"
#include "perilymph/foundation/AtomicFile.h"
#include "perilymph/foundation/Result.h"

namespace perilymph::charts {

/// Writes a drawing as PNG with 216 pixels per inch, atomically.
Result<void> writePicture(const figures::Drawing& drawing, const std::filesystem::path& file,
                          const Writing& how = {});

}  // namespace perilymph::charts
