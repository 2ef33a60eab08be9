// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Distance between two surfaces.

#include "perilymph/anatomy/Surface.h"
#include "perilymph/foundation/Units.h"

namespace perilymph::anatomy {

/// Distances between two surfaces in both directions, weighted by area.
struct SurfaceDeviation {
  Length mean;
  Length p95;       ///< 95th percentile over both surfaces.
  Length greatest;  ///< Maximum over the sampled points.
};

/// Compares two surfaces at points at most `spacing` apart on each: corners and intermediate
/// points.
SurfaceDeviation surfaceDistance(const Surface& one, const Surface& other, Length spacing);

}  // namespace perilymph::anatomy
