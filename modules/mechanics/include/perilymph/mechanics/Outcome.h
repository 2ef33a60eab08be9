// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Final position of an array: what the published study calls the outcome of an insertion.

#include <Eigen/Core>
#include <span>
#include <vector>

#include "perilymph/mechanics/InsertionModel.h"

namespace perilymph::mechanics {

/// Position and orientation of one electrode contact.
struct ContactOutcome {
  double fromTip = 0.0;                                  ///< Distance from the tip along the array
                                                         ///< [m].
  Eigen::Vector3d position_W = Eigen::Vector3d::Zero();  ///< On the center line [m].
  bool isInside = false;        ///< Past the plane of the entry. If false, nothing below is set.
  double angle = 0.0;           ///< Angle from the round window [rad], full turns included.
  double toModiolarAxis = 0.0;  ///< [m]
  /// Distance from the center line to the inner wall, in the direction of the modiolar axis [m];
  /// also defined for an array pressed beyond the outer wall. Negative if there is no lumen in that
  /// direction.
  double toInnerWall = 0.0;
  /// Angle between the contact's facing direction and the direction to the modiolar axis, seen
  /// along the array [rad]: 0 faces the modiolus, pi the outer wall.
  double offModiolus = 0.0;
};

/// The shape of an array, from a state, a snapshot or a record.
struct ArrayShape {
  std::span<const Eigen::Vector3d> nodes_W;  ///< From the tweezers to the tip [m].
  /// Unit, per node: direction of curl, in which the contacts face. If empty, it is transported
  /// from `baseCurl_W` along the array without twist.
  std::span<const Eigen::Vector3d> curl_W;
  Eigen::Vector3d baseCurl_W = Eigen::Vector3d::UnitX();  ///< At the tweezers.
};

/// Outcome of every contact, from the tip. Allocates and takes about 0.1 ms: not for the tick.
///
/// @throws std::invalid_argument if the number of nodes differs from the model's.
std::vector<ContactOutcome> outcomeOf(const InsertionModel& model, const ArrayShape& shape);

/// The same without a model, for an array with equally spaced nodes in a lumen.
///
/// @throws std::invalid_argument if the shape has fewer than 2 nodes.
std::vector<ContactOutcome> outcomeOf(const anatomy::Lumen& lumen,
                                      const electrode::ArrayDesign& array, const ArrayShape& shape);

}  // namespace perilymph::mechanics
