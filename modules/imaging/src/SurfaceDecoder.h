// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// STL and VTP surfaces as VTK reads them.

#include <filesystem>
#include <optional>
#include <string>

#include "perilymph/anatomy/Surface.h"

namespace perilymph::imaging {

/// Reads a surface of triangles. Empty if the file is damaged; on some damaged files VTK prints or
/// allocates gigabytes, so that untrusted files are read in a child process.
///
/// @param ending  ".stl" or ".vtp".
std::optional<anatomy::Surface> decodeSurface(const std::filesystem::path& file,
                                              const std::string& ending);

}  // namespace perilymph::imaging
