#pragma once

// PLY by hand: VTK's reader ends the program on a file that was cut off.

#include <optional>
#include <string>

#include "perilymph/anatomy/Surface.h"

namespace perilymph::imaging {

/// The polygons of a PLY file's content in millimeters, as triangles; text or binary of both byte
/// orders. Nothing where the content is no whole PLY file of a surface.
std::optional<anatomy::Surface> readPly(const std::string& content);

}  // namespace perilymph::imaging
