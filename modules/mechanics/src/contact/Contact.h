// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The compliant wall: normal force and friction on every node that touches.

#include "contact/ContactSet.h"
#include "friction/FrictionHistory.h"
#include "perilymph/mechanics/InsertionModel.h"
#include "perilymph/mechanics/InsertionState.h"
#include "rod/RodKinematics.h"
#include "solver/BandMatrix.h"

namespace perilymph::mechanics {

/// Force of a compliant wall: smooth onset over `onset`, then linear.
NormalForce normalForce(double penetration, double stiffness, double onset) noexcept;

/// Energy stored in a compliant wall [J]; normalForce() is its derivative.
double energyOf(double penetration, double stiffness, double onset) noexcept;

/// Force of a wall that is partly membrane and partly bone, in parallel. Its energy also depends on
/// the fraction.
struct SoftContactForce {
  NormalForce normal;
  double onMembrane;  ///< The membrane's part of the force [N].
  double byFraction;  ///< Derivative of the energy by the membrane's fraction [J].
};

/// @param bone      Stiffness of the bone there [N/m].
/// @param fraction  Of the membrane, 0 to 1.
/// @param parts     With a membrane law.
SoftContactForce softContactForce(double penetration, double bone, double fraction,
                                  const ModelParts& parts) noexcept;

/// Extent of an oval section toward a wall: its support function along the wall's normal. With a
/// delay, it follows the wall's direction from one step, with the reach `before`, to the next.
SectionReach reachToward(const InsertionModel& model, const InsertionState& state,
                         const RodKinematics& rod, std::size_t i, const Eigen::Vector3d& normal_W,
                         const SectionReach& before) noexcept;

/// Adds the wall's forces on all nodes at state.position_W to force_W and stores them in
/// state.normalForce and state.wallForce_W, and the nodes that touch in contacts.touching.
void addWallForces(const InsertionModel& model, InsertionState& state, const StepStart& start,
                   const RodKinematics& rod, ContactSet& contacts, FrictionHistory& history,
                   std::vector<Eigen::Vector3d>& force_W) noexcept;

/// Error of friction due to its bound by an earlier pressure than that of the last forces: the sum
/// over all contacts [N].
double frictionLag(const InsertionModel& model, const InsertionState& state,
                   const ContactSet& contacts, const FrictionHistory& history) noexcept;

/// Sets the bound of friction to the pressure of the last forces.
void renewFriction(const InsertionState& state, const ContactSet& contacts,
                   FrictionHistory& history) noexcept;

/// Adds the wall's stiffness after addWallForces() to the matrix.
void addWallStiffness(const InsertionState& state, bool hasFilm, const ContactSet& contacts,
                      const FrictionHistory& history, BandMatrix& matrix) noexcept;

}  // namespace perilymph::mechanics
