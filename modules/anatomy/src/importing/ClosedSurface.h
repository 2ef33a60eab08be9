// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// A validated imported surface: one component, closed except for its opening, facing outward, of
// the size of a scala tympani.

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "importing/SurfaceSpikes.h"
#include "perilymph/anatomy/Surface.h"
#include "perilymph/foundation/Result.h"

namespace perilymph::anatomy {

struct ClosedSurface {
  Surface surface;                   ///< Watertight: holes are closed by triangle fans.
  std::vector<bool> isLid;           ///< Per triangle: it closes the opening and is not wall.
  std::vector<Eigen::Vector3d> rim;  ///< Rim of the opening; empty if the surface was closed.
  double volume = 0.0;               ///< [m^3]
  std::optional<SurfaceSpike> spike;
};

/// Merges equal corners, closes cracks, orients the triangles, closes small holes and the opening. An error if the
/// surface cannot be a scala tympani in its unit.
Result<ClosedSurface> closeSurface(const Surface& soup);

}  // namespace perilymph::anatomy
