// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Relaxation of the bent carrier: Maxwell elements beside its elastic stiffness.
//
// An element with the fraction g of the stiffness B and the time constant tau stores g B/(2 h) |x - v|^2
// for the bend x beyond the rest bend and its own, v, which follows x:
//
//     v' = (v + (dt/tau) x) / (1 + dt/tau)     backward Euler
//
// In a step it acts as a spring of g B/h / (1 + dt/tau) that is at rest at the v of the start: the
// energy of the step stays quadratic, and none is gained. All elements and the elastic part together
// are one spring at rest at a mean of the v, the held bend. v belongs to the material: it has
// components along the two axes of its node, which turn with the edges and their directions of curl.

#include "lanes/Lanes.h"
#include "perilymph/mechanics/InsertionModel.h"
#include "perilymph/mechanics/InsertionState.h"
#include "rod/RodKinematics.h"

namespace perilymph::mechanics {

/// The axes of a node, or of four: unit vectors perpendicular to the array, toward its direction of curl
/// and perpendicular to that.
template <class T>
struct NodeAxes {
  Triple<T> along, across;

  PERILYMPH_IN_LANES NodeAxes(const RodKinematics& rod, const std::vector<Eigen::Vector3d>& curl_W,
                              std::size_t i) noexcept
  {
    const Triple<T> p = load<T>(rod.tangent_W, i - 1), t = load<T>(rod.tangent_W, i);
    const Triple<T> both = p + t;
    const T inverse = 1.0 / root(larger(dot(both, both), 1e-12));
    const Triple<T> middle = inverse * both;
    const Triple<T> curl = load<T>(curl_W, i - 1) + load<T>(curl_W, i);
    const Triple<T> rest = curl - dot(curl, middle) * middle;
    const T inverseRest = 1.0 / root(larger(dot(rest, rest), 1e-12));
    along = inverseRest * rest;
    across = cross(middle, along);
  }
};

/// Fraction of its bending stiffness that a joint has in a step of the model's duration.
///
/// @param relaxing  Fraction of that stiffness that belongs to the carrier and can relax.
double relaxedStiffness(const InsertionModel& model, double relaxing) noexcept;

/// Sets the rest bend in components along the axes of each node, with what elements and wires hold of it.
void setHeldBend(const InsertionModel& model, const InsertionState& state,
                 SectionStiffness& section) noexcept;

/// The rest bend of a joint as the mean of a vector of each of its edges, for the turn of the material.
template <class T>
struct HeldJoint {
  Triple<T> last, next;          ///< Those vectors.
  Triple<T> lastRate, nextRate;  ///< Their derivatives by the rotation of their edge.
  T along, across;               ///< Components of the rest bend.

  /// @param joint  With the directions of curl d and e, and dAcross, eAcross perpendicular to them.
  template <class TurningJoint>
  PERILYMPH_IN_LANES HeldJoint(const TurningJoint& joint, const T& toward, const T& aside) noexcept
      : along(toward), across(aside)
  {
    last = along * joint.d + across * joint.dAcross;
    next = along * joint.e + across * joint.eAcross;
    lastRate = along * joint.dAcross - across * joint.d;
    nextRate = along * joint.eAcross - across * joint.e;
  }
};

/// Adds what elements and wires hold to rod.restBend_W, along the axes that each node keeps in this step.
void holdBends(const InsertionModel& model, const InsertionState& state,
               const SectionStiffness& section, RodKinematics& rod) noexcept;

/// Lets the elements follow the bends at the end of a step, and wires take up what they yielded.
///
/// @return  Work dissipated by yielding [J].
double commitBends(const InsertionModel& model, const SectionStiffness& section, RodKinematics& rod,
                   InsertionState& state) noexcept;

}  // namespace perilymph::mechanics
