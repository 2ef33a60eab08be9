// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Memory of the point set's solver.

#include "points/HalfSpaces.h"

namespace perilymph::mechanics {

/// Intermediate results of one time step, not kept between steps.
struct PointWorkspace {
  HalfSpaces allowed;  ///< Constraints by the triangles near a proxy.
};

}  // namespace perilymph::mechanics
