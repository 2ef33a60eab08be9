#pragma once

// How well an array lies: what the published study calls the outcome of an insertion.

#include <Eigen/Core>
#include <span>
#include <vector>

#include "perilymph/mechanics/InsertionModel.h"

namespace perilymph::mechanics {

/// Where one contact of the array lies, and where it looks.
struct ContactOutcome {
  double fromTip = 0.0;                                  ///< Along the array [m].
  Eigen::Vector3d position_W = Eigen::Vector3d::Zero();  ///< On the center line [m].
  bool isInside = false;        ///< Past the plane of the entry. If not, nothing below is set.
  double angle = 0.0;           ///< From the round window [rad], turns counted.
  double toModiolarAxis = 0.0;  ///< [m]
  /// From the center line to the inner wall, along the way to the modiolar axis [m]; also from
  /// where an array is pressed beyond the outer one. Negative if no lumen lies that way.
  double toInnerWall = 0.0;
  /// Between where it looks and the way to the modiolar axis, seen along the array [rad]: 0 looks
  /// at the modiolus, pi at the outer wall.
  double offModiolus = 0.0;
};

/// The shape of an array: of a state, or of a picture or a record made from one.
struct ArrayShape {
  std::span<const Eigen::Vector3d> nodes_W;  ///< From the tweezers to the tip [m].
  /// Unit, per node: to where it curls, which is where the contacts look. Without any, carried
  /// along the array from `baseCurl_W` without turning about it.
  std::span<const Eigen::Vector3d> curl_W;
  Eigen::Vector3d baseCurl_W = Eigen::Vector3d::UnitX();  ///< At the tweezers.
};

/// Outcome of every contact, from the tip on. Allocates, takes some 0.1 ms: not for the tick.
///
/// @throws std::invalid_argument if the shape has not the model's number of nodes.
std::vector<ContactOutcome> outcomeOf(const InsertionModel& model, const ArrayShape& shape);

/// The same without a model: of an array with equal distances between its nodes, in a lumen.
///
/// @throws std::invalid_argument if the shape has fewer than 2 nodes.
std::vector<ContactOutcome> outcomeOf(const anatomy::Lumen& lumen,
                                      const electrode::ArrayDesign& array, const ArrayShape& shape);

}  // namespace perilymph::mechanics
