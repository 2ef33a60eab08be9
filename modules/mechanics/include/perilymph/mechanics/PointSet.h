#pragma once

// The published model of an array: a few spheres on springs (Todd and Naghdy, "Real-time Haptic
// Modeling and Simulation for Prosthetic Insertion", sections II.C and II.D). Kept as it was
// published, limits and all: the published curves came from it, and the rod is compared with it.
//
// What the paper says, and what is done:
// - Twelve sample points of radius 0.25 mm on the straight axis of the carrier, each with linear
//   stiffness and damping (350 N/m, 1.0 N.s/m): each is a mass on a spring-damper to its place.
// - "The points move about the carrier's longitudinal axis" with rotational stiffness and damping
//   (0.2 N.m/rad, 3e-5 N.m.s/rad) and a box inertia: the axis with all places turns about the
//   tweezers against that spring.
// - The proxies of the points meet the haptic surface of the scala: 441 N/m along its normal,
//   200 N/m along it, damping 0.01. Sticks up to 0.0605 times the normal force, slides with 0.0395,
//   rests again below 0.0185.
// - Insertion or withdrawal is told from the proxy against the device along E.z. While inserting,
//   0.0395 |F_x| is added to F_z, while withdrawing it is taken off.
// - From the collision in the vicinity of the basal turn on, all points are put anew on the axis
//   of the carrier, depending on the insertion distance.
//
// What the paper leaves open, and what is chosen here (confidence low unless said):
//  1. Places: evenly from tweezers to tip; the first point is the held one.
//  2. Inertia: the published mass is that of "the carrier ... applied to the sample points", so the
//     points carry it in equal shares, and the frame they hang on weighs nothing of its own.
//     Turning has the inertia of a box of that mass and the published 3 x 2 x 2 cm along E's axes.
//  3. "Boundary conditions for sample point movement" of the same 3, 2 and 2 cm: no point leaves
//  its
//     place by more than half of that each way.
//  4. What "the vicinity of the basal turn" is: where the wall stands across the way in more than
//     along it. The collision there is the first of a point whose normal is within 45 degrees of
//     the way out.
//  5. Where the points go: evenly between the tweezers and the place on the axis where the tip was
//     at that collision. So the foremost stays in the turn, the others close up behind it, and the
//     part of the carrier that went around the turn is not represented. This is the reading in
//     which a straight carrier can be "fully implanted" and the force still rises.
//  6. The carrier's proxy along z is the mean of the points, the device's position that of their
//     places. So a withdrawal is told apart only once the wall pulls at the carrier: until then
//     friction still counts as that of an insertion.
//  7. Surface damping is in N.s/m, along the normal. (Its source is a loss tangent of bone.)
//  8. Integration: semi-implicit Euler at 1 kHz, several equal steps where the time step of a model
//     is longer. It is what bounds the number of points.
//  9. A point past the opening meets the wall with a radius that grows with its depth up to its
//  own:
//     the rim of a surface without thickness would hit it all at once.
// 10. The axis turns by small angles: new = old + turn x old, made a unit vector.
// Absent, as in the paper: stylet, basilar membrane, recoil, adhesion, shape of the array (only its
// length counts), bone around the opening. The angular depth is that of the foremost point.

#include <Eigen/Core>
#include <cstdint>
#include <vector>

namespace perilymph {
class Hash;
}

namespace perilymph::mechanics {

/// The most points a model may have: the paper's dozen many times over.
inline constexpr int maxPoints = 256;

struct PointSetModel;

/// What changes while it runs, beside the common parts of InsertionState.
struct PointSetState {
  /// Place of each point on the carrier, and its proxy on the haptic surface [m].
  std::vector<Eigen::Vector3d> place_W, proxy_W;
  Eigen::Vector3d hand_W = Eigen::Vector3d::Zero();       ///< Where the hand was last [m].
  Eigen::Vector3d handAxis_W = Eigen::Vector3d::UnitZ();  ///< Unit: its axis then.
  Eigen::Vector3d turn_W =
      Eigen::Vector3d::Zero();  ///< Rotation of the carrier in the tweezers [rad].
  Eigen::Vector3d turnRate_W = Eigen::Vector3d::Zero();  ///< [rad/s]
  Eigen::Vector3d friction_W = Eigen::Vector3d::Zero();  ///< Added to the hand's force [N].
  /// Force of the points on the carrier [N] and moment about the tweezers [N.m], last step.
  Eigen::Vector3d pull_W = Eigen::Vector3d::Zero(), moment_W = Eigen::Vector3d::Zero();
  double turnedAt = -1.0;      ///< Insertion distance at the basal-turn collision [m]; < 0: none.
  std::uint64_t atBounds = 0;  ///< How often a point was stopped at its bounds.

  void addTo(Hash& hash) const noexcept;
};

}  // namespace perilymph::mechanics
