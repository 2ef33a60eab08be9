// SPDX-License-Identifier: BSD-3-Clause
#include "CameraPath.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "perilymph/foundation/Units.h"

namespace perilymph::visualization {
namespace {

/// The paper rotates the scala by 110 degrees so that its opening is visible. Counted clockwise
/// from the round window straight down, this puts the opening on the left.
constexpr double surgeonTurn_deg = 110.0;
constexpr double microscopeTilt_deg = 40.0;  ///< Off the approach, so that the array hides less.
constexpr double overviewElevation_deg = 38.0;
constexpr double followTimeConstant_s = 0.15;

constexpr double surgeonMagnification = 10.0;
constexpr double microscopeMagnification = 16.0;
constexpr double overviewMagnification = 8.0;
constexpr double followMagnification = 24.0;
constexpr double sectionMagnification = 14.0;

/// Looks against `back`, with `up` as far upward as possible.
Eigen::Quaterniond looking(const Eigen::Vector3d& back, const Eigen::Vector3d& up)
{
  Eigen::Matrix3d axes;
  axes.col(2) = back.normalized();
  axes.col(0) = up.cross(axes.col(2)).normalized();
  axes.col(1) = axes.col(2).cross(axes.col(0));
  return Eigen::Quaterniond(axes);
}

Eigen::Vector3d mirrored(const Eigen::Vector3d& vector)
{
  return {vector.x(), -vector.y(), vector.z()};
}

/// The up vector that shows the round window (on the x axis) rotated from straight down.
Eigen::Vector3d surgeonUp()
{
  // The x axis appears at -90 - 110 degrees in the picture; up is 90 degrees further.
  const double upFromX = degrees(90.0 - (-90.0 - surgeonTurn_deg)).si();
  return {std::cos(upFromX), std::sin(upFromX), 0.0};
}

/// The preset for a right ear.
CameraPose rightEarPose(CameraPreset preset, const CameraSubject& subject,
                        const Eigen::Vector3d& tip)
{
  const Eigen::Vector3d apex = Eigen::Vector3d::UnitZ();
  const Eigen::Vector3d middle = 0.5 * (subject.low + subject.high);
  switch (preset) {
    case CameraPreset::surgeon:
      return {looking(apex, surgeonUp()), middle, surgeonMagnification};
    case CameraPreset::followTip:
      return {looking(apex, surgeonUp()), tip, followMagnification};
    case CameraPreset::microscope: {
      const double tilt = degrees(microscopeTilt_deg).si();
      const Eigen::Vector3d back = std::cos(tilt) * subject.out + std::sin(tilt) * apex;
      return {looking(back, apex), subject.opening - 1.5 * subject.out, microscopeMagnification};
    }
    case CameraPreset::overview: {
      // from the side of the opening, above the plane of the basal turn
      const double rise = degrees(overviewElevation_deg).si();
      const Eigen::Vector3d aside = (subject.out + 1.2 * subject.outward).normalized();
      const Eigen::Vector3d back = std::cos(rise) * aside + std::sin(rise) * apex;
      return {looking(back, apex), middle + 2.5 * subject.out, overviewMagnification};
    }
    case CameraPreset::section:
      return {looking(-Eigen::Vector3d::UnitY(), apex), middle, sectionMagnification};
  }
  return {};
}

double smooth(double x) { return x * x * (3.0 - 2.0 * x); }

}  // namespace

CameraPose presetPose(CameraPreset preset, const CameraSubject& subject, const Eigen::Vector3d& tip)
{
  if (!subject.mirrors) return rightEarPose(preset, subject, tip);

  // Mirror to a right ear, apply the preset, and mirror back: the picture is the mirror image.
  CameraSubject right = subject;
  right.low = {subject.low.x(), -subject.high.y(), subject.low.z()};
  right.high = {subject.high.x(), -subject.low.y(), subject.high.z()};
  right.opening = mirrored(subject.opening);
  right.out = mirrored(subject.out);
  right.outward = mirrored(subject.outward);
  CameraPose pose = rightEarPose(preset, right, mirrored(tip));
  const Eigen::Matrix3d axes = pose.axes.toRotationMatrix();
  pose.axes = looking(mirrored(axes.col(2)), mirrored(axes.col(1)));
  pose.focus = mirrored(pose.focus);
  return pose;
}

bool showsAll(CameraPreset preset)
{
  return preset == CameraPreset::surgeon || preset == CameraPreset::overview ||
         preset == CameraPreset::section;
}

CameraPose framed(const CameraPose& pose, const std::vector<Eigen::Vector3d>& points, double aspect,
                  const FreeArea& area, double share)
{
  const Eigen::Matrix3d axes = pose.axes.toRotationMatrix();
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Eigen::Array2d low(infinity, infinity), high(-infinity, -infinity);
  for (const Eigen::Vector3d& point : points) {
    const Eigen::Array2d place = (axes.leftCols<2>().transpose() * point).array();
    low = low.min(place);
    high = high.max(place);
  }
  // the picture's height at which the larger extent fills its share
  const Eigen::Array2d free(aspect * (area.right - area.left), area.top - area.bottom);
  const double height_mm = ((high - low) / (share * free)).maxCoeff();
  CameraPose result = pose;
  result.magnification = std::clamp(fieldHeight_mm / height_mm, minMagnification, maxMagnification);

  const double shown_mm = fieldHeight_mm / result.magnification;
  const Eigen::Array2d middle(aspect * (0.5 * (area.left + area.right) - 0.5),
                              0.5 * (area.bottom + area.top) - 0.5);
  const Eigen::Vector2d focus = (0.5 * (low + high) - shown_mm * middle).matrix();
  result.focus = axes.leftCols<2>() * focus + axes.col(2) * axes.col(2).dot(pose.focus);
  return result;
}

void CameraPath::jump(const CameraPose& pose)
{
  from_ = to_ = now_ = pose;
  progress_ = 1.0;
}

void CameraPath::glide(const CameraPose& pose)
{
  from_ = now_;
  to_ = pose;
  progress_ = 0.0;
}

void CameraPath::aim(const CameraPose& pose)
{
  if (isGliding())
    to_ = pose;
  else
    jump(pose);
}

CameraPose& CameraPath::take()
{
  if (isGliding()) jump(to_);
  return now_;
}

bool CameraPath::step(double seconds)
{
  if (!isGliding()) return false;
  progress_ = std::min(1.0, progress_ + std::max(0.0, seconds) / glideTime_s);
  const double fraction = smooth(progress_);
  now_.axes = from_.axes.slerp(fraction, to_.axes);
  now_.focus = from_.focus + fraction * (to_.focus - from_.focus);
  now_.magnification =
      from_.magnification * std::pow(to_.magnification / from_.magnification, fraction);
  if (!isGliding()) now_ = to_;
  return true;
}

void CameraPath::follow(const Eigen::Vector3d& focus, double seconds)
{
  if (isGliding()) {
    to_.focus = focus;
    return;
  }
  const double fraction = 1.0 - std::exp(-std::max(0.0, seconds) / followTimeConstant_s);
  now_.focus += fraction * (focus - now_.focus);
  to_ = now_;
}

}  // namespace perilymph::visualization
