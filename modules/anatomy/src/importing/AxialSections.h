// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Cuts of a closed surface by half-planes through an axis, and tracking of the duct from cut to
// cut.

#include <Eigen/Core>
#include <vector>

#include "perilymph/anatomy/Surface.h"

namespace perilymph::anatomy {

/// A frame whose z is an axis; angles are counted from its x. Columns are unit vectors.
struct AxisFrame {
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();

  Eigen::Vector3d into(const Eigen::Vector3d& point) const
  {
    return axes.transpose() * (point - origin);
  }
  Eigen::Vector3d outOf(const Eigen::Vector3d& point) const { return origin + axes * point; }
};

/// One closed line in which a half-plane through the axis cuts the surface.
struct AxialSection {
  double angle = 0.0;         ///< From the frame's x [rad]; full turns are counted once tracked.
  double centerRadius = 0.0;  ///< Distance of the area's centroid from the axis [m].
  double centerHeight = 0.0;  ///< [m]
  double area = 0.0;          ///< [m^2]
  double innerRadius = 0.0, outerRadius = 0.0, floorHeight = 0.0, roofHeight = 0.0;  ///< [m]
};

/// The closed lines in the half-plane at an angle.
std::vector<AxialSection> sectionsAt(const Surface& closed, const AxisFrame& frame, double angle);

/// The duct as sections from its basal to its apical end; angles increase toward the apex, and so
/// must the frame's. Starts in the first turn and proceeds in both directions while a section
/// similar to the last one is near it; the ends are located to 0.05 degrees. Empty if no duct winds
/// about the axis.
std::vector<AxialSection> followDuct(const Surface& closed, const AxisFrame& frame);

}  // namespace perilymph::anatomy
