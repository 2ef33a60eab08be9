// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Reading of segmented surfaces from other programs.

#include <filesystem>

#include "perilymph/anatomy/Surface.h"
#include "perilymph/foundation/Result.h"

namespace perilymph::imaging {

/// Reads a surface in millimeters, in the format of the file extension: stl, ply (text or binary)
/// or vtp. Polygons are triangulated. An error if the file is not such a surface.
Result<anatomy::Surface> readSurface(const std::filesystem::path& file);

}  // namespace perilymph::imaging
