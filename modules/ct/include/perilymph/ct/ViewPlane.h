// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Planes in which a CT is looked at: the patient's, and those of the cochlea.

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "perilymph/ct/CtVolume.h"
#include "perilymph/ct/Measures.h"

namespace perilymph::ct {

/// A picture plane in P [mm]. The viewer looks along right x down.
struct ViewPlane {
  Eigen::Vector3d center_P = Eigen::Vector3d::Zero();
  Eigen::Vector3d right_P = Eigen::Vector3d::UnitX();  ///< Unit, to the right in the picture.
  Eigen::Vector3d down_P = Eigen::Vector3d::UnitY();   ///< Unit, at right angles to right_P.

  Eigen::Vector3d away_P() const { return right_P.cross(down_P); }
  /// Position of a point in the picture, right and down from the center [mm].
  Eigen::Vector2d inPicture(const Eigen::Vector3d& point_P) const
  {
    return {right_P.dot(point_P - center_P), down_P.dot(point_P - center_P)};
  }
  /// The point of the plane at a position in the picture [mm].
  Eigen::Vector3d atPicture(const Eigen::Vector2d& place_mm) const
  {
    return center_P + place_mm.x() * right_P + place_mm.y() * down_P;
  }
  /// Distance of a point from the plane, positive behind it as seen by the viewer [mm].
  double behind(const Eigen::Vector3d& point_P) const { return away_P().dot(point_P - center_P); }
  /// Whether a line runs along the plane, within 30 degrees, and not out of it.
  bool runsAlong(const Eigen::Vector3d& from_P, const Eigen::Vector3d& to_P) const
  {
    const Eigen::Vector3d between = to_P - from_P;
    return std::fabs(away_P().dot(between)) <= 0.5 * between.norm();
  }
};

/// Axial, coronal and sagittal planes through a point, as radiologists view them: the patient's left
/// at the right, anterior and superior at the top.
std::array<ViewPlane, 3> patientPlanes(const Eigen::Vector3d& center_P);

/// The cochlear view and two mid-modiolar planes through a point. In the cochlear view (Xu et al.
/// 2000) the apex is toward the viewer and the round window straight down, so that A is vertical
/// and B horizontal; both mid-modiolar planes have the apex at the top, one along A, one along B.
std::array<ViewPlane, 3> cochlearPlanes(const CochleaMeasures& measures,
                                        const Eigen::Vector3d& center_P);

/// The point that the cochlear view is opened at: on the axis, in the middle of the basal turn's
/// lumen.
Eigen::Vector3d basalTurnCenter_P(const CochleaMeasures& measures);

/// The patient's directions that a unit vector in P points to, at most three letters of R, L, A, P,
/// S, I, the largest component first; components below a fifth are left out: "L", "AS".
std::string directionLetters(const Eigen::Vector3d& direction_P);

/// A line in a picture, right and down from its center [mm].
using PictureLine = std::array<Eigen::Vector2d, 2>;

/// The lines in which a plane cuts the measured wall, unordered.
std::vector<PictureLine> wallOutline(const CochleaMeasures& measures, const ViewPlane& plane);

}  // namespace perilymph::ct
