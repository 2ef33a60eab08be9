// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Rims of a surface that is not closed: that of its opening, of small holes, and of tears.

#include <string>
#include <vector>

#include "perilymph/anatomy/Surface.h"
#include "perilymph/foundation/Result.h"

namespace perilymph::anatomy {

/// A closed line of edges that belong to one triangle each.
struct SurfaceRim {
  std::vector<int> corners;  ///< In the order of a lid's triangles.
  double length = 0.0;       ///< [m]
};

/// A longer rim is the opening, a shorter one a hole of the segmentation [m].
inline constexpr double openingRim = 2e-3;

/// A corner as "(x, y, z) mm".
std::string placeOf(const Surface& surface, int index);

/// The refusal of a surface one of whose corners lies so far from its neighbors [m].
Error tornAt(const Surface& surface, int index, double gap);

/// The rims, the longest first.
std::vector<SurfaceRim> rimsOf(const Surface& surface);

/// Refuses rims that are no opening or small hole of a scala, with their places in the file's frame:
///
/// - a tear: one corner is farther from the others than 0.35 mm and than twice the edges there, as
///   where a corner of a triangle was moved away from its neighbors;
/// - a second rim longer than `openingRim`;
/// - an opening that is none: a slit, or a hole in the side of the duct, whose rim lies in the wall
///   that surrounds it rather than across it.
Result<void> checkRims(const Surface& surface, const std::vector<SurfaceRim>& rims);

}  // namespace perilymph::anatomy
