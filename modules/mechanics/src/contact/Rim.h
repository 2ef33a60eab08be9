#pragma once

// The rim of the opening: one contact between the array's center line and an edge.

#include <Eigen/Core>

#include "contact/ContactSet.h"
#include "friction/FrictionHistory.h"
#include "perilymph/mechanics/InsertionModel.h"
#include "perilymph/mechanics/InsertionState.h"
#include "rod/RodKinematics.h"
#include "solver/BandMatrix.h"

namespace perilymph::mechanics {

/// The place on an ellipse that a point inside or outside is nearest to, by the direction u of the
/// ellipse's outward normal there: h(u) is the ellipse's reach in that direction.
struct EllipseFoot {
  double normal[2];  ///< u
  double distance;   ///< h(u) - c.u: from the point to the ellipse, negative outside [m].
  double reachRate;  ///< Derivative of h by the angle of u [m].
  double bending;    ///< Radius of curvature there less the distance [m], above 0.
};

/// @param x, y  The point c from the ellipse's center [m].
/// @param a, b  Half-axes along x and y [m].
EllipseFoot nearestOnEllipse(double x, double y, double a, double b) noexcept;

/// How far the ribs stand out at a place along the array, and how fast that grows away from the
/// tip: height (1 - (x / reach)^2)^2 at the distance x from the middle of a rib, where `reach` is
/// half its length and the rim's roundness (the shape is a choice, low).
struct RibProfile {
  double height;  ///< [m]
  double slope;   ///< 1
};
RibProfile ribsAt(const InsertionModel& model, double fromTip) noexcept;

/// Adds the rim's force on the array at state.position_W to force_W, and leaves the contact and its
/// stiffness in `contacts`.
///
/// Between the nodes the center line is a quadratic B-spline, so that nothing jumps when a node
/// passes the plane of the opening; its section there has the array's radius with the ribs on it.
/// Where the section overlaps the ellipse, the compliant wall pushes back: one sample point's
/// stiffness at the nearest place of the rim, and another opposite to it if it overlaps there too.
/// The push is the gradient of its energy: across the array, and along it on the flank of a rib.
/// A tip still outside meets the rounded rim and the bone around it as a sphere.
void addRimForces(const InsertionModel& model, const InsertionState& state, const StepStart& start,
                  const FrictionHistory& history, ContactSet& contacts,
                  std::vector<Eigen::Vector3d>& force_W) noexcept;

/// Adds the rim's stiffness to the matrix, as addRimForces() has left it.
void addRimStiffness(const ContactSet& contacts, BandMatrix& matrix) noexcept;

}  // namespace perilymph::mechanics
