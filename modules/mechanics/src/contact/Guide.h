// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Forceps near the opening: the array outside is held straight up to a free length.

#include <Eigen/Core>
#include <vector>

#include "perilymph/mechanics/InsertionModel.h"
#include "perilymph/mechanics/advance.h"
#include "solver/BandMatrix.h"

namespace perilymph::mechanics {

/// The line on which forceps hold the array, at one time step, and what they add to it.
struct GuideLine {
  explicit GuideLine(std::size_t nodes = 0) : stiffness(nodes, 0.0) {}

  Eigen::Vector3d origin_W = Eigen::Vector3d::Zero();  ///< A point on it [m].
  Eigen::Vector3d axis_W = Eigen::Vector3d::Zero();    ///< Unit.
  std::vector<double> stiffness;                       ///< Across it, at each node [N/m].
};

/// Lays the line through the base along the axis of the tweezers.
void setGuide(const Drive& drive, const Eigen::Vector3d& base_W, GuideLine& guide) noexcept;

/// Adds the force of the forceps on each node, and the reaction to node 0, where the hand is.
///
/// Surgeons take the array a few millimeters in front of the opening, advance it, and take it
/// again. Continuous in place of these strokes, the energy of a node at the height z above the
/// opening and the distance d from the line is
///
///     E = k h w d^2 / 2
///
/// with the node spacing h and the mean w over its segment, h long, of a weight that is 0 below the
/// free length, 1 from 0.5 mm above it and smooth between: with the weight of the node itself, the free
/// length would be longer by up to h. Along the line the array slides freely: all axial force is the base's.
/// Without a free length it adds nothing.
///
/// @param height  Of each node above the opening [m].
void addGuideForces(const InsertionModel& model, const std::vector<Eigen::Vector3d>& position_W,
                    const std::vector<double>& height, GuideLine& guide,
                    std::vector<Eigen::Vector3d>& force_W) noexcept;

/// Adds its stiffness, as stored by addGuideForces(), to the matrix.
void addGuideStiffness(const InsertionModel& model, const GuideLine& guide,
                       BandMatrix& matrix) noexcept;

}  // namespace perilymph::mechanics
