// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// PLY reader: VTK's reader terminates the program on a truncated file.

#include <optional>
#include <string>

#include "perilymph/anatomy/Surface.h"

namespace perilymph::imaging {

/// The polygons of a PLY file's content in millimeters, as triangles; text or binary of either byte
/// order. Empty if the content is not a complete PLY surface.
std::optional<anatomy::Surface> readPly(const std::string& content);

}  // namespace perilymph::imaging
