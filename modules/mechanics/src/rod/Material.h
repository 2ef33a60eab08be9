#pragma once

// What the rod remembers of how it was made: to where it curls at every edge, how it resists being
// twisted, and in which direction an oval section is stiffer. Nothing of this is needed for an
// array that is straight and round.

#include "perilymph/mechanics/InsertionModel.h"
#include "perilymph/mechanics/InsertionState.h"
#include "rod/RodKinematics.h"
#include "solver/BandMatrix.h"

namespace perilymph::mechanics {

/// Carries the material's directions to where the edges are now, turns that of the first edge with
/// the hand, and lets the others follow: one Newton step toward the least energy
///
///     sum of 1/2 (GJ/h) m_i^2 + bending + what oval sections press into the wall,
///
/// where m_i is the angle by which edge i is twisted against the edge before it. Needs rod.edge and
/// rod.inverseSum; leaves the rest bends, the twist and the torque on the hand in `rod`.
///
/// Positions move in between, by the same energies at these directions: both halves of the step can
/// only take energy out. As they move, the twist at node i follows to first order,
///
///     m_i(x) = m_i + b_i . (x_{i+1} - x_{i-1}),   b_i = p x t / (h (1 + p.t)),
///
/// with the tangents p and t of the edges before and after the node at the start of the step.
void turnMaterial(const InsertionModel& model, const Eigen::Vector3d& curl_W,
                  const SectionStiffness& section, InsertionState& state, RodKinematics& rod,
                  TwistSystem& turns) noexcept;

/// The rest of the bending moment at node i where an oval section is stiffer in one direction
/// [N.m].
Eigen::Vector3d ovalStress(const InsertionModel& model, double timeStep,
                           const SectionStiffness& section, const RodKinematics& rod, std::size_t i,
                           const Eigen::Vector3d& bend_W) noexcept;

/// Adds the stiffness of the twist and of oval sections to the matrix.
void addMaterialStiffness(const InsertionModel& model, double timeStep,
                          const SectionStiffness& section, const RodKinematics& rod,
                          BandMatrix& matrix) noexcept;

}  // namespace perilymph::mechanics
