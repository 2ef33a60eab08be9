#pragma once

// The compliant wall: normal force and friction on every node that touches.

#include "contact/ContactSet.h"
#include "friction/FrictionHistory.h"
#include "perilymph/mechanics/InsertionModel.h"
#include "perilymph/mechanics/InsertionState.h"
#include "rod/RodKinematics.h"
#include "solver/BandMatrix.h"

namespace perilymph::mechanics {

/// Force of a compliant wall by depth of penetration, and its slope. Sets in smoothly over `onset`,
/// then linear.
struct NormalForce {
  double force;  ///< [N]
  double slope;  ///< [N/m]
};
NormalForce normalForce(double penetration, double stiffness, double onset) noexcept;

/// The energy stored in a compliant wall [J]: normalForce() is its derivative.
double energyOf(double penetration, double stiffness, double onset) noexcept;

/// Force of a wall that is partly membrane, side by side with bone. Its energy changes with the
/// share, too.
struct SoftContactForce {
  NormalForce normal;
  double onMembrane;  ///< Its part of the force [N].
  double byFraction;  ///< Derivative of the energy by the share of membrane [J].
};

/// @param bone   Stiffness of the bone there [N/m].
/// @param share  Of the membrane, 0 to 1.
/// @param parts  With a law of the membrane.
SoftContactForce softContactForce(double penetration, double bone, double fraction,
                                  const ModelParts& parts) noexcept;

/// Adds the wall's forces on all nodes at state.position_W to force_W, and leaves them in
/// state.normalForce and state.wallForce_W, and their stiffness in contacts.wallStiffness.
void addWallForces(const InsertionModel& model, InsertionState& state, const StepStart& start,
                   const RodKinematics& rod, ContactSet& contacts, FrictionHistory& history,
                   std::vector<Eigen::Vector3d>& force_W) noexcept;

/// By how much friction may be wrong for being bounded by an older pressure than that of the last
/// forces: the sum over all contacts [N].
double frictionLag(const InsertionModel& model, const InsertionState& state,
                   const ContactSet& contacts, const FrictionHistory& history) noexcept;

/// Bounds friction by the pressure of the last forces.
void renewFriction(const InsertionState& state, const ContactSet& contacts,
                   FrictionHistory& history) noexcept;

/// Adds the wall's stiffness to the matrix, as addWallForces() has left it.
void addWallStiffness(const ContactSet& contacts, BandMatrix& matrix) noexcept;

}  // namespace perilymph::mechanics
