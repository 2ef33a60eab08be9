#pragma once

// A surface from elsewhere, checked: one piece, closed but for its opening, facing outward, of the
// size of a scala tympani.

#include <Eigen/Core>
#include <vector>

#include "perilymph/anatomy/Surface.h"
#include "perilymph/foundation/Result.h"

namespace perilymph::anatomy {

struct ClosedSurface {
  Surface surface;                   ///< Watertight: holes are closed by fans.
  std::vector<bool> isLid;           ///< Per triangle: closes the opening, is no wall.
  std::vector<Eigen::Vector3d> rim;  ///< Around the opening; empty where the surface was closed.
  double volume = 0.0;               ///< [m^3]
};

/// Merges equal corners, turns triangles one way round, closes small holes and the opening. A
/// sentence where the surface cannot be a scala tympani in the unit it came in.
Result<ClosedSurface> closeSurface(const Surface& soup);

}  // namespace perilymph::anatomy
