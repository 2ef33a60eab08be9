// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The line along which an array is pushed into a measured cochlea, and its distance from marks in the CT.

#include <Eigen/Core>
#include <span>

#include "perilymph/anatomy/Approach.h"
#include "perilymph/ct/Measures.h"

namespace perilymph::ct {

/// The line of approach in P: from the center of the opening outward, without end.
struct ApproachLine {
  Eigen::Vector3d opening_P = Eigen::Vector3d::Zero();   ///< [mm]
  Eigen::Vector3d outward_P = Eigen::Vector3d::UnitZ();  ///< Unit.

  /// The point at a distance from the opening [mm].
  Eigen::Vector3d at(double outside_mm) const { return opening_P + outside_mm * outward_P; }
};

/// @param entry  The opening of the anatomy that is built from the measures.
ApproachLine approachLine(const CochleaMeasures& measures, const anatomy::Entry& entry,
                          const anatomy::Approach& approach);

/// The approach whose line points outward along a direction of P, of any length but 0.
anatomy::Approach approachAlong(const CochleaMeasures& measures, const anatomy::Entry& entry,
                                const Eigen::Vector3d& outward_P);

/// Shortest distance between a mark in a CT and a line of approach.
///
/// The standard deviation of the mark's place along that distance: of placing by hand, and of a voxel,
/// which is uniform between its borders. It holds nothing else: no width of a nerve or a drill, and no
/// error of navigation or of the hand.
struct DistanceToLine {
  double distance_mm = 0.0;
  double sd_mm = 0.0;
  double outside_mm = 0.0;  ///< From the opening to the nearest point of the line.
  Eigen::Vector3d mark_P = Eigen::Vector3d::Zero();  ///< The nearest point of the mark.
};

/// @param points_P      The mark: a point, or more that are connected in their order [mm]; not empty.
/// @param voxelEdges_P  Edges of a voxel, as columns [mm].
DistanceToLine distanceToLine(std::span<const Eigen::Vector3d> points_P, const ApproachLine& line,
                              const Eigen::Matrix3d& voxelEdges_P);

}  // namespace perilymph::ct
