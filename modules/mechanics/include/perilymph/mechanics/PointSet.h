// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The published model of an array: a few spheres on springs (Todd and Naghdy, "Real-time Haptic
// Modeling and Simulation for Prosthetic Insertion", sections II.C and II.D). Implemented as
// published, with its limitations: it produced the published curves, and the rod is compared with
// it.
//
// What the paper states, and how it is implemented:
// - Twelve sample points of radius 0.25 mm on the straight axis of the carrier, each with linear
// - Twelve sample points of radius 0.25 mm on the straight axis of the carrier, each with linear
//   stiffness and damping (350 N/m, 1.0 N.s/m): each is a mass on a spring-damper to its anchor.
// - "The points move about the carrier's longitudinal axis" with rotational stiffness and damping
//   (0.2 N.m/rad, 3e-5 N.m.s/rad) and a box inertia: the axis with all anchors rotates about the
//   tweezers against that spring.
// - The proxies of the points touch the haptic surface of the scala: 441 N/m along its normal,
//   200 N/m along it, damping 0.01. A point sticks up to 0.0605 times the normal force, slides with
//   0.0395, and sticks again below 0.0185.
// - Insertion and withdrawal are distinguished by the proxy relative to the device along E.z.
//   During insertion 0.0395 |F_x| is added to F_z, during withdrawal it is subtracted.
// - From the collision in the vicinity of the basal turn on, all points are repositioned on the
//   axis of the carrier, depending on the insertion distance.
//
// What the paper does not state, and what is chosen here (confidence low unless stated):
//  1. Anchors: equally spaced from tweezers to tip; the first point is the held one.
//  2. Inertia: the published mass is that of "the carrier ... applied to the sample points", so the
//     points have equal parts of it, and the frame that they are attached to is massless. Rotation
//     has the inertia of a box of that mass and the published 3 x 2 x 2 cm along E's axes.
//  3. "Boundary conditions for sample point movement" of the same 3, 2 and 2 cm: no point moves
//     more than half of that from its anchor in each direction.
//  4. "The vicinity of the basal turn": where the wall is more across the insertion direction than
//     along it. The collision there is the first one of a point whose normal is within 45 degrees
//     of the outward direction.
//  5. Repositioning: equally spaced between the tweezers and the position of the tip on the axis
//     at that collision. So the foremost point stays in the turn, the others close up behind it,
//     and the part of the carrier that went around the turn is not represented. With this
//     interpretation a straight carrier can be "fully implanted" and the force still rises.
//  6. The carrier's proxy along z is the mean of the points, the device's position that of their
//     anchors. So a withdrawal is detected only when the wall holds the carrier back: until then
//     friction acts as during insertion.
//  7. Surface damping is in N.s/m, along the normal. (Its source is a loss tangent of bone.)
//  8. Integration: semi-implicit Euler at 1 kHz, with several equal substeps if the time step of
//     a model is longer. This limits the number of points.
//  9. A point past the opening has a contact radius that grows with its depth up to the full
//     radius: otherwise the rim of a surface without thickness would hit it abruptly.
// 10. The axis rotates by small angles: new = old + turn x old, normalized.
// Absent, as in the paper: stylet, basilar membrane, recoil, adhesion, shape of the array (only
// its length matters), bone around the opening. The angular depth is that of the foremost point.

#include <Eigen/Core>
#include <cstdint>
#include <vector>

namespace perilymph {
class Hash;
}

namespace perilymph::mechanics {

/// Number of sample points of the published carrier (section II.C).
inline constexpr int publishedPoints = 12;

/// Maximum number of points of a model.
inline constexpr int maxPoints = 256;

/// Maximum number of points with which a published run is stable at 1 kHz (test/bench,
/// stability/points; confidence high). More points make lighter ones on the same springs.
inline constexpr int maxStablePoints = 18;

struct PointSetModel;

/// Variable data of a point set, in addition to the common parts of InsertionState.
struct PointSetState {
  /// Position of each point on the carrier, and of its proxy on the haptic surface [m].
  std::vector<Eigen::Vector3d> place_W, proxy_W;
  Eigen::Vector3d hand_W = Eigen::Vector3d::Zero();       ///< Last position of the hand [m].
  Eigen::Vector3d handAxis_W = Eigen::Vector3d::UnitZ();  ///< Unit: last axis of the hand.
  Eigen::Vector3d turn_W =
      Eigen::Vector3d::Zero();  ///< Rotation of the carrier in the tweezers [rad].
  Eigen::Vector3d turnRate_W = Eigen::Vector3d::Zero();  ///< [rad/s]
  Eigen::Vector3d friction_W = Eigen::Vector3d::Zero();  ///< Added to the hand's force [N].
  /// Force of the points on the carrier [N] and moment about the tweezers [N.m], last step.
  Eigen::Vector3d pull_W = Eigen::Vector3d::Zero(), moment_W = Eigen::Vector3d::Zero();
  double turnedAt = -1.0;      ///< Insertion distance at the basal-turn collision [m]; < 0: none.
  std::uint64_t atBounds = 0;  ///< Number of times a point was stopped at its bounds.

  void addTo(Hash& hash) const noexcept;
};

}  // namespace perilymph::mechanics
