// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The elastic rod: stretching and bending of a chain of nodes, with material damping.

#include <Eigen/Core>
#include <cstddef>

#include "perilymph/mechanics/InsertionModel.h"
#include "perilymph/mechanics/InsertionState.h"
#include "rod/RodKinematics.h"

namespace perilymph::mechanics {

/// Ratio of material damping to stiffness: stress = E (strain + time x strain rate). An engineering
/// choice that damps vibration between ticks; confidence low.
inline constexpr double dampingTime = 2e-3;  // [s]

/// Block index of a node: nodes 0 and 1 belong to the base.
inline std::size_t blockOf(std::size_t node) noexcept { return node == 0 ? 0 : node - 1; }

/// Sets EI and rest bend of each node for a position of the stylet.
///
/// The stylet adds its own EI along its length, and straightens the carrier except for a fraction
/// of the free curvature. `released` is the fraction of the rest curvature that the array has taken
/// on.
void setStiffness(const InsertionModel& model, double styletWithdrawal, double released,
                  SectionStiffness& section) noexcept;

/// Sets the rest bends h kappa d as vectors: the direction of curl d is transported along the rod
/// from the base without twist (for an array that does not twist). Also stores lengths and bends at
/// the start of the step, relative to which damping is computed. Needs the edges there.
void setRestShape(const InsertionModel& model, const Eigen::Vector3d& curl_W,
                  const SectionStiffness& section, RodKinematics& rod) noexcept;

/// Computes the rod's edges at these positions.
void setEdges(const std::vector<Eigen::Vector3d>& position_W, RodKinematics& rod) noexcept;

/// Sets force_W to the rod's forces, and stores its edges and their tension in `rod`.
void setRodForces(const InsertionModel& model, const std::vector<Eigen::Vector3d>& position_W,
                  const SectionStiffness& section, RodKinematics& rod,
                  std::vector<Eigen::Vector3d>& force_W) noexcept;

}  // namespace perilymph::mechanics
