#pragma once

// From the frame W in meters to the picture's space in millimeters; a left ear is mirrored here.

#include <Eigen/Core>

#include "perilymph/anatomy/Patient.h"

namespace perilymph::visualization {

/// The one place where meters become millimeters and right ears become left ones.
class PictureSpace {
public:
  explicit PictureSpace(anatomy::Side side) : mirrors_(side == anatomy::Side::left) {}

  bool mirrors() const { return mirrors_; }
  /// A place [m, W] in the picture's space [mm].
  Eigen::Vector3d place(const Eigen::Vector3d& point_W) const { return 1e3 * direction(point_W); }
  /// A direction or a force of W in the picture's space.
  Eigen::Vector3d direction(const Eigen::Vector3d& vector_W) const
  {
    return {vector_W.x(), mirrors_ ? -vector_W.y() : vector_W.y(), vector_W.z()};
  }

private:
  bool mirrors_;
};

/// Where the camera looks from: its axes in the picture's space and the size of a pixel.
struct ViewFrame {
  Eigen::Vector3d right = Eigen::Vector3d::UnitX();
  Eigen::Vector3d up = Eigen::Vector3d::UnitY();
  Eigen::Vector3d back = Eigen::Vector3d::UnitZ();  ///< Toward the viewer.
  double pixel_mm = 0.025;

  friend bool operator==(const ViewFrame&, const ViewFrame&) = default;
};

}  // namespace perilymph::visualization
