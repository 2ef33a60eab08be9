// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The rim of the opening: contact between the array's center line and an edge.

#include <Eigen/Core>

#include "contact/ContactSet.h"
#include "friction/FrictionHistory.h"
#include "perilymph/mechanics/InsertionModel.h"
#include "perilymph/mechanics/InsertionState.h"
#include "rod/RodKinematics.h"
#include "solver/BandMatrix.h"

namespace perilymph::mechanics {

/// The point of an ellipse nearest to a given point, described by the outward unit normal u there:
/// h(u) is the ellipse's support function.
struct EllipseFoot {
  double normal[2];  ///< u
  double distance;   ///< h(u) - c.u: distance from the point to the ellipse, negative outside [m].
  double reachRate;  ///< Derivative of h by the angle of u [m].
  double bending;    ///< Radius of curvature minus the distance [m], above 0.
};

/// @param x, y  The point c from the ellipse's center [m].
/// @param a, b  Half-axes along x and y [m].
EllipseFoot nearestOnEllipse(double x, double y, double a, double b) noexcept;

/// Height of the ribs above the carrier at a distance from the tip, and its derivative: height (1 -
/// (x / reach)^2)^2 at the distance x from the middle of a rib, where `reach` is half its length
/// plus the rim's edge radius (the shape is a choice, low).
struct RibProfile {
  double height;  ///< [m]
  double slope;   ///< 1
};
RibProfile ribsAt(const InsertionModel& model, double fromTip) noexcept;

/// Adds the rim's force on the array at state.position_W to force_W, and stores the contact and its
/// stiffness in `contacts`.
///
/// Between the nodes the center line is a quadratic B-spline, so that forces are continuous when a
/// node passes the plane of the opening; its section there has the array's radius including ribs.
/// Where the section overlaps the ellipse, the compliant wall acts with one sample point's
/// stiffness at the nearest point of the rim, and with another one opposite if the section overlaps
/// there too. The force is the gradient of its energy: across the array, and along it on the flank
/// of a rib. A tip still outside touches the rounded rim and the bone around it as a sphere. An
/// opening with a passage acts on an array inside as described at addPassageForces(). Needs
/// contacts.height.
void addRimForces(const InsertionModel& model, const InsertionState& state, const StepStart& start,
                  const FrictionHistory& history, ContactSet& contacts,
                  std::vector<Eigen::Vector3d>& force_W) noexcept;

/// Adds the stiffness of the rim and of its passage, as stored by addRimForces(), to the matrix.
void addRimStiffness(const InsertionModel& model, const ContactSet& contacts,
                     BandMatrix& matrix) noexcept;

}  // namespace perilymph::mechanics
