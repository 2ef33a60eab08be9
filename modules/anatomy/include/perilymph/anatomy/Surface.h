// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Triangle surfaces for display and files, from the tables used by the mechanics.

#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include "perilymph/anatomy/ScalaTympani.h"
#include "perilymph/foundation/Result.h"

namespace perilymph::anatomy {

/// A triangle mesh in W [m]; the order of the corners defines the outward normal.
struct Surface {
  std::vector<std::array<double, 3>> points;
  std::vector<std::array<int, 3>> triangles;
};

/// The wall from the opening to the apex, closed at the apex and open at the opening, with at most
/// `maxTriangles` triangles (200 or more).
Surface wallSurface(const ScalaTympani& scala, int maxTriangles);

/// The triangles of wallSurface() up to an angle: open at both ends.
Surface wallSurfaceBefore(const ScalaTympani& scala, int maxTriangles, Angle end);

/// The basilar membrane as a ribbon inside the wall.
Surface membraneSurface(const ScalaTympani& scala, int maxTriangles);

/// Writes a surface in millimeters, in the format of the file extension: stl (binary), ply, obj,
/// wrl (VRML 2.0) or vtp. The file is written atomically.
Result<void> writeSurface(const Surface& surface, const std::string& title,
                          const std::filesystem::path& file);

}  // namespace perilymph::anatomy
