#pragma once

// Writes a print figure as a PNG file, without display or OpenGL.

#include <filesystem>

#include "perilymph/figures/Drawing.h"
#include "perilymph/foundation/Result.h"

namespace perilymph::charts {

/// Writes a drawing as PNG with 216 pixels an inch; the file appears whole or not at all.
Result<Done> writePicture(const figures::Drawing& drawing, const std::filesystem::path& file);

}  // namespace perilymph::charts
