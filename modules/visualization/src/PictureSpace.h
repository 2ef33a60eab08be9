// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Conversion from frame W in meters to picture space in millimeters; a left ear is mirrored here.

#include <Eigen/Core>

#include "perilymph/anatomy/Patient.h"

namespace perilymph::visualization {

/// The only place that converts meters to millimeters and mirrors left ears.
class PictureSpace {
public:
  explicit PictureSpace(anatomy::Side side) : mirrors_(side == anatomy::Side::left) {}

  bool mirrors() const { return mirrors_; }
  /// A point [m, W] in picture space [mm].
  Eigen::Vector3d place(const Eigen::Vector3d& point_W) const { return 1e3 * direction(point_W); }
  /// A direction or force of W in picture space.
  Eigen::Vector3d direction(const Eigen::Vector3d& vector_W) const
  {
    return {vector_W.x(), mirrors_ ? -vector_W.y() : vector_W.y(), vector_W.z()};
  }

private:
  bool mirrors_;
};

/// The camera's axes in picture space and the size of a pixel.
struct ViewFrame {
  Eigen::Vector3d right = Eigen::Vector3d::UnitX();
  Eigen::Vector3d up = Eigen::Vector3d::UnitY();
  Eigen::Vector3d back = Eigen::Vector3d::UnitZ();  ///< Toward the viewer.
  double pixel_mm = 0.025;

  friend bool operator==(const ViewFrame&, const ViewFrame&) = default;
};

}  // namespace perilymph::visualization
