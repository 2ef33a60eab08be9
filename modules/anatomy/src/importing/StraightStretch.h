// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Length of the straight wall behind an opening.

#include <set>

#include "importing/ClosedSurface.h"

namespace perilymph::anatomy {

/// The rim of an opening, and the direction in which the wall leaves it.
struct RimFrame {
  Eigen::Vector3d center = Eigen::Vector3d::Zero();  ///< [m]
  Eigen::Vector3d plane = Eigen::Vector3d::Zero();   ///< Normal of the rim's plane, unit.
  Eigen::Vector3d inward = Eigen::Vector3d::Zero();  ///< Along the wall, unit.
  std::set<int> corners;  ///< Corners of the surface on the rim and in the middle of its lid.
  double scatter = 0.0;   ///< Mean square of the wall normals' component along `inward`, at the
                          ///< rim.

  /// Distance of a point from the rim's plane, along `inward` [m].
  double depth(const Eigen::Vector3d& place) const
  {
    return (place - center).dot(plane) / inward.dot(plane);
  }
};

/// Length of the straight stretch of wall behind a rim [m]; 0 if there is none. It depends
/// continuously on the corners of the surface as long as their noise is small compared with the
/// stretch:
///
/// - Where the corners form rings, as on a surface swept along a duct, the stretch ends with the
///   last ring parallel to the rim: planes through many corners average their noise.
/// - Otherwise, if the rim's wall is straight to 0.06 degrees, it ends with the last triangle that
///   is.
/// - Otherwise it ends where the wall's mean tilt over 0.2 mm exceeds what its noise explains.
double straightStretch(const ClosedSurface& closed, const RimFrame& rim);

}  // namespace perilymph::anatomy
