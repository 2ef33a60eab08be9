#pragma once

// The memory of the point set's solver.

#include "points/HalfSpaces.h"

namespace perilymph::mechanics {

/// Intermediate results of one time step. Nothing outlives it.
struct PointWorkspace {
  HalfSpaces allowed;  ///< What the triangles near a proxy allow it.
};

}  // namespace perilymph::mechanics
