// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Spikes of a surface: single corners that stand out of the wall.

#include <optional>

#include "importing/SurfaceRims.h"
#include "perilymph/anatomy/Surface.h"

namespace perilymph::anatomy {

/// A corner that stands out of all its neighbors.
struct SurfaceSpike {
  int corner = 0;
  double height = 0.0;  ///< Above the nearest of its neighbors, along the spike [m].
};

/// The highest spike of a surface whose corners are shared; empty if none is higher than 0.1 mm and
/// than four fifths of the edges around its corner. On a smooth wall, along a ridge and in a
/// staircase of voxels the neighbors of a corner are level with it or nearly so; three walls that
/// meet at right angles make 0.6 edges.
std::optional<SurfaceSpike> highestSpike(const Surface& surface);

/// The corner of an opening's rim that lies farthest from the curve through its neighbors; empty if
/// none is farther than 0.1 mm, than the edges of the rim there, and than three times the median.
std::optional<SurfaceSpike> highestSpike(const Surface& surface, const SurfaceRim& rim);

}  // namespace perilymph::anatomy
