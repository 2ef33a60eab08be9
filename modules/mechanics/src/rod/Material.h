// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The material frame of the rod: direction of curl at every edge, torsional stiffness, and the
// stiffer direction of oval sections. Not needed for a straight round array.

#include "perilymph/mechanics/InsertionModel.h"
#include "perilymph/mechanics/InsertionState.h"
#include "rod/RodKinematics.h"

namespace perilymph::mechanics {

/// Transports the material directions to the current edges, rotates that of the first edge with the
/// hand, and moves the others by one Newton step toward the minimum of the energy
///
///     sum of 1/2 (GJ/h) m_i^2 + bending + contact energy of oval sections,
///
/// where m_i is the twist of edge i against the edge before it. Needs the edges and rod.inverseSum;
/// stores the rest bends, the twist and the torque on the hand in `rod`.
///
/// Positions are then solved with these directions and the same energies: neither half of the step
/// adds energy. As the nodes move, the twist at node i follows to first order,
///
///     m_i(x) = m_i + b_i . (x_{i+1} - x_{i-1}),   b_i = p x t / (h (1 + p.t)),
///
/// with the tangents p and t of the edges before and after the node at the start of the step.
void turnMaterial(const InsertionModel& model, const Eigen::Vector3d& curl_W,
                  const SectionStiffness& section, InsertionState& state, RodKinematics& rod,
                  TwistSystem& turns) noexcept;

}  // namespace perilymph::mechanics
