// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The wall of a fitted lumen as points in W, and its measures. Lengths in mm.

#include <Eigen/Core>
#include <vector>

#include "LumenShape.h"
#include "perilymph/foundation/Units.h"

namespace perilymph::ct {

/// Rings of points around the sections, `around` each, from `firstAngle` on.
struct LumenWall {
  static constexpr int around = 32;
  static constexpr double step = 4.0 * pi / 180.0;  ///< Between rings [rad].

  double firstAngle = 0.0;
  std::vector<Eigen::Vector3d> points_W;  ///< `around` per ring, the first one radially outward.

  int rings() const { return static_cast<int>(points_W.size()) / around; }
  const Eigen::Vector3d& at(int ring, int k) const
  {
    return points_W[static_cast<std::size_t>(ring * around + k)];
  }
};

/// The wall from an angle to the apex.
LumenWall wallOf(const ShapedLumen& lumen, double firstAngle);

/// The frame of clinical measures: z along the clinical axis, x toward the round window.
/// Right-handed in W.
struct ClinicalFrame {
  Eigen::Vector3d origin_W = Eigen::Vector3d::Zero();  ///< On the axis, at the height of the
                                                       ///< window.
  Eigen::Matrix3d axes_W = Eigen::Matrix3d::Identity();

  Eigen::Vector3d from_W(const Eigen::Vector3d& point_W) const
  {
    return axes_W.transpose() * (point_W - origin_W);
  }
};

/// Center of the cupola: the mean of the wall's points within 0.5 mm of its highest one.
Eigen::Vector3d cupola_W(const LumenWall& wall);

/// Center of the modiolus in the basal turn, on W's axis [mm]; the clinical axis runs through it.
Eigen::Vector3d modiolusBase_W();

/// The clinical axis, from the modiolus' center in the basal turn to the center of the cupola, of a
/// wall of mean shape. An individual's cupola would add more error than it removes: its sections
/// there are the least certain.
Eigen::Vector3d clinicalAxis_W(const LumenWall& mean);

/// @param axis_W  The clinical axis, unit.
ClinicalFrame clinicalFrame(const Eigen::Vector3d& axis_W, const Eigen::Vector3d& roundWindow_W);

/// Diameters and height in a clinical frame.
struct WallMeasures {
  double a, b, h;
};
/// A: from the round window through the axis to the opposite wall. B: perpendicular to it. H: from
/// the lowest floor to the highest roof of the given wall.
WallMeasures measureWall(const LumenWall& wall, const ClinicalFrame& frame,
                         const Eigen::Vector3d& roundWindow_W);

}  // namespace perilymph::ct
