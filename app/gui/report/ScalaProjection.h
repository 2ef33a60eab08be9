// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Projection of a cochlea along its modiolar axis, for pictures on paper.

#include <Eigen/Core>
#include <QPointF>

#include "perilymph/anatomy/Patient.h"
#include "perilymph/anatomy/ScalaTympani.h"

namespace perilymph::gui {

/// Projection from the cochlear frame W [m] to a plane viewed toward the apex [mm], y downward, the
/// modiolar axis at the origin. The opening is at the upper left of a right ear; a left ear is its
/// mirror image.
class ScalaProjection {
public:
  ScalaProjection(const anatomy::ScalaTympani& scala, anatomy::Side side);

  QPointF at(double x, double y) const;
  QPointF at(const Eigen::Vector3d& point_W) const { return at(point_W.x(), point_W.y()); }
  /// The point at an angle from the round window [rad] and a distance from the axis [mm].
  QPointF polar(double angle, double radius_mm) const;

private:
  double mirror_, cosine_ = 1.0, sine_ = 0.0;
};

}  // namespace perilymph::gui
