#pragma once

// Segmented surfaces, as other programs write them.

#include <filesystem>

#include "perilymph/anatomy/Surface.h"
#include "perilymph/foundation/Result.h"

namespace perilymph::imaging {

/// Reads a surface in millimeters, by the file's ending: stl, ply (text or binary) or vtp. Polygons
/// become triangles. A sentence where the file is no such surface.
Result<anatomy::Surface> readSurface(const std::filesystem::path& file);

}  // namespace perilymph::imaging
