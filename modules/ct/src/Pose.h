// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Pose of the cochlear frame W in the patient.

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace perilymph::ct {

/// Frame W in the patient's frame P [mm]. Columns of `axes_PW` are unit vectors; their determinant
/// is 1 for a right ear and -1 for a left one, whose W is mirrored.
struct Pose {
  Eigen::Matrix3d axes_PW = Eigen::Matrix3d::Identity();
  Eigen::Vector3d origin_P = Eigen::Vector3d::Zero();

  Eigen::Vector3d into_W(const Eigen::Vector3d& point_P) const
  {
    return axes_PW.transpose() * (point_P - origin_P);
  }
  Eigen::Vector3d outOf_W(const Eigen::Vector3d& point_W) const
  {
    return origin_P + axes_PW * point_W;
  }
  bool isRight() const { return axes_PW.col(0).cross(axes_PW.col(1)).dot(axes_PW.col(2)) > 0.0; }

  /// The pose after a small rotation [rad] and a translation, both in W. A rational function of its
  /// arguments, without sines.
  Pose moved(const Eigen::Vector3d& turn_W, const Eigen::Vector3d& shift_W) const
  {
    const Eigen::Quaterniond small =
        Eigen::Quaterniond(1.0, 0.5 * turn_W.x(), 0.5 * turn_W.y(), 0.5 * turn_W.z()).normalized();
    return {axes_PW * small.toRotationMatrix(), origin_P + axes_PW * shift_W};
  }
};

}  // namespace perilymph::ct
