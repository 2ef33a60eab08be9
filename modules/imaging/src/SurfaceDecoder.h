// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// STL, PLY and VTP surfaces as VTK reads them.

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>

#include "perilymph/anatomy/Surface.h"

namespace perilymph::imaging {

/// Reads a surface of triangles. Empty if the file is damaged; on some damaged files VTK prints,
/// allocates gigabytes or ends the program, so that untrusted files are read in a child process.
///
/// @param ending   ".stl", ".ply" or ".vtp".
/// @param corners  Becomes the number of all polygons' corners, before they are triangles.
std::optional<anatomy::Surface> decodeSurface(const std::filesystem::path& file,
                                              const std::string& ending, std::size_t& corners);

}  // namespace perilymph::imaging
