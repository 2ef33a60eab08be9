// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Camera pose and its motion between poses.

#include <Eigen/Geometry>
#include <vector>

#include "PictureSpace.h"
#include "perilymph/visualization/InsertionScene.h"

namespace perilymph::visualization {

/// A camera pose. The projection is parallel.
struct CameraPose {
  Eigen::Quaterniond axes = Eigen::Quaterniond::Identity();  ///< Camera's right, up, back.
  Eigen::Vector3d focus = Eigen::Vector3d::Zero();           ///< At the center of the picture [mm].
  double magnification = 10.0;
};

/// The geometry that presets depend on, in picture space.
struct CameraSubject {
  Eigen::Vector3d low, high;     ///< Box around the wall [mm].
  Eigen::Vector3d opening;       ///< [mm]
  Eigen::Vector3d out, outward;  ///< Axes of the entry, unit.
  bool mirrors = false;          ///< A left ear.
};

/// Height of the picture at magnification 1 [mm]: about the field of view of a surgical microscope.
inline constexpr double fieldHeight_mm = 170.0;
inline constexpr double minMagnification = 4.0;
inline constexpr double maxMagnification = 32.0;

/// The pose of a preset. A left ear's is the mirror image of a right ear's.
CameraPose presetPose(CameraPreset preset, const CameraSubject& subject,
                      const Eigen::Vector3d& tip);

/// Whether a preset shows the whole cochlea.
bool showsAll(CameraPreset preset);

/// The pose with another magnification and focus, so that points lie within an area of the picture and
/// extend over a share of its width or height; within the limits of the magnification.
///
/// @param aspect  Width of the picture over its height.
CameraPose framed(const CameraPose& pose, const std::vector<Eigen::Vector3d>& points, double aspect,
                  const FreeArea& area, double share);

/// A moving camera.
class CameraPath {
public:
  static constexpr double glideTime_s = 0.25;

  void jump(const CameraPose& pose);
  void glide(const CameraPose& pose);
  /// Changes where a motion ends, or the pose itself at rest.
  void aim(const CameraPose& pose);
  /// @return Whether the camera moved and may move again.
  bool step(double seconds);

  const CameraPose& pose() const { return now_; }
  /// Where its motion ends; the pose itself at rest.
  const CameraPose& target() const { return isGliding() ? to_ : now_; }
  /// Changes the pose directly; ends a motion.
  CameraPose& take();
  /// Moves the target of a motion, or the pose itself, to follow the tip.
  void follow(const Eigen::Vector3d& focus, double seconds);
  bool isGliding() const { return progress_ < 1.0; }

private:
  CameraPose from_, to_, now_;
  double progress_ = 1.0;
};

}  // namespace perilymph::visualization
