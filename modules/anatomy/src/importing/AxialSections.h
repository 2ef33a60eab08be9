#pragma once

// Cuts of a closed surface in planes through an axis, and the duct followed from cut to cut.

#include <Eigen/Core>
#include <vector>

#include "perilymph/anatomy/Surface.h"

namespace perilymph::anatomy {

/// A frame whose z is an axis; angles count from its x. Columns are unit vectors.
struct AxisFrame {
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();

  Eigen::Vector3d into(const Eigen::Vector3d& point) const
  {
    return axes.transpose() * (point - origin);
  }
  Eigen::Vector3d outOf(const Eigen::Vector3d& point) const { return origin + axes * point; }
};

/// One closed line in which a plane through the axis cuts the surface, on the side of its angle.
struct AxialSection {
  double angle = 0.0;         ///< From the frame's x [rad], turns counted once followed.
  double centerRadius = 0.0;  ///< Distance of the area's center from the axis [m].
  double centerHeight = 0.0;  ///< [m]
  double area = 0.0;          ///< [m^2]
  double innerRadius = 0.0, outerRadius = 0.0, floorHeight = 0.0, roofHeight = 0.0;  ///< [m]
};

/// The closed lines of the half-plane at an angle, in a frame.
std::vector<AxialSection> sectionsAt(const Surface& closed, const AxisFrame& frame, double angle);

/// The duct as sections from its basal end to its apical one, angles growing toward the apex (the
/// frame's angles must do so, too). Starts in the first turn and goes both ways as long as a
/// section much like the last one is near it; the ends are found to 0.05 degrees. Empty where no
/// duct winds about the axis.
std::vector<AxialSection> followDuct(const Surface& closed, const AxisFrame& frame);

}  // namespace perilymph::anatomy
