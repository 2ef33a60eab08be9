// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Where the center line of the array crosses a plane across the opening.

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "perilymph/mechanics/InsertionModel.h"

namespace perilymph::mechanics {

/// Intersection of the center line, a quadratic B-spline between the nodes, with a plane across the
/// opening.
struct Crossing {
  std::size_t first = 0;    ///< First of the nodes that define it.
  std::size_t count = 0;    ///< 3, or 2 in the last half edge; 0: no intersection.
  double weight[3] = {};    ///< Weight of each node; they add up to 1.
  Eigen::Vector3d at_W;     ///< [m]
  Eigen::Vector3d along_W;  ///< Derivative of the center line by its parameter [m].
  double fromTip = 0.0;     ///< [m]
  double radius = 0.0;      ///< Radius of the carrier there, without ribs [m].
  double radiusRate = 0.0;  ///< Its derivative by the parameter [m].
};

/// Intersection with the plane of the opening at which the array enters. Not while its tip is
/// outside: any part below the plane is then only bent onto the bone. Of several intersections, the
/// one nearest to the previous entry.
///
/// @param height  Of each node above that plane [m]; positive outside.
Crossing crossingOf(const InsertionModel& model, const std::vector<Eigen::Vector3d>& x,
                    const std::vector<double>& height, double fromTip) noexcept;

/// The next intersection with a plane inside, behind an intersection further out.
///
/// @param plane  Height of that plane above the opening [m]: negative.
Crossing crossingBehind(const InsertionModel& model, const std::vector<Eigen::Vector3d>& x,
                        const std::vector<double>& height, double plane,
                        const Crossing& outer) noexcept;

}  // namespace perilymph::mechanics
