// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The ridge of the metal: the path that the array takes in the ear, for contacts that are not seen singly.

#include <Eigen/Core>
#include <vector>

#include "EarFrame.h"
#include "MetalGrid.h"

namespace perilymph::outcome {

/// The ridge from its apical end toward the opening and beyond it, as far as the metal goes, 0.1 mm apart;
/// empty if there is none near the duct. A minimal path through bright cells that stays in its turn.
std::vector<Eigen::Vector3d> ridgeOf(const MetalGrid& grid, const EarFrame& frame);

/// Points that follow the metal from a point on, the first in about a direction and none in more than 60 degrees to the
/// one before, at equal distances.
std::vector<Eigen::Vector3d> followed(const MetalGrid& grid, const Eigen::Vector3d& from_P,
                                      const Eigen::Vector3d& direction_P, double distance_mm,
                                      int count);

/// Point of a polyline at a distance from its start; continued straight beyond its ends.
Eigen::Vector3d alongPolyline(const std::vector<Eigen::Vector3d>& points, double distance);

}  // namespace perilymph::outcome
