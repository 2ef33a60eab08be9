#pragma once

// How far two surfaces are apart.

#include "perilymph/anatomy/Surface.h"
#include "perilymph/foundation/Units.h"

namespace perilymph::anatomy {

/// Distances between two surfaces, both ways, each place weighted by its area.
struct SurfaceDeviation {
  Length mean;
  Length p95;       ///< 95 % of both surfaces are nearer to the other than this.
  Length greatest;  ///< Maximum over the sampled places.
};

/// Compares two surfaces at places at most `spacing` apart on each: corners, and points between.
SurfaceDeviation surfaceDistance(const Surface& one, const Surface& other, Length spacing);

}  // namespace perilymph::anatomy
