#include "Balance.h"

#include <algorithm>
#include <cmath>

#include "contact/Contact.h"
#include "contact/Rim.h"
#include "rod/Material.h"

namespace perilymph::mechanics {
namespace {

SymmetricBlock<double> uniform(double stiffness) noexcept
{
  return {stiffness, 0.0, 0.0, stiffness, 0.0, stiffness};
}

/// Greatest and sum of squares over all blocks; a number that is none is kept, not lost.
Balance leftOver(const std::vector<Eigen::Vector3d>& right) noexcept
{
  double worst = 0.0;
  double squares[3] = {0.0, 0.0, 0.0};  // one sum an axis: three short chains instead of a long one
  for (const Eigen::Vector3d& force : right)
    for (int k = 0; k < 3; ++k) {
      worst = std::max(worst, std::fabs(force[k]));
      squares[k] += force[k] * force[k];
    }
  const double sum = squares[0] + squares[1] + squares[2];
  return {std::isfinite(sum) ? worst : sum, sum};
}

}  // namespace

Base baseOf(const InsertionModel& model, const InsertionState& state, const Drive& drive) noexcept
{
  const double dt = state.room.timeStep;
  Base base{};
  base.isHeld = drive.coupling == Coupling::rigid;
  base.inertia = model.baseMass / (dt * dt);
  base.grip = drive.couplingStiffness + drive.couplingDamping / dt;
  base.free_W = state.base_W + dt * state.baseVelocity_W;
  base.gripped_W = drive.handPosition_W;
  if (base.grip > 0.0)
    base.gripped_W = (drive.couplingStiffness * drive.handPosition_W +
                      drive.couplingDamping * (state.base_W / dt + drive.handVelocity_W)) /
                     base.grip;
  return base;
}

void setHold(const InsertionModel& model, InsertionState& state) noexcept
{
  StepRoom& room = state.room;
  const double perTime = 1.0 / room.timeStep;
  for (std::size_t i = 2; i < state.position_W.size(); ++i) {
    const double inertia = model.mass[i] * perTime;
    room.hold[i] = (inertia + model.drag[i]) * perTime;
    // inertia takes it on as fast as it was; drag would leave it where it is
    room.goal_W[i] = room.before_W[i] + (inertia / room.hold[i]) * state.velocity_W[i];
  }
}

Balance balance(const InsertionModel& model, InsertionState& state, const Base& base) noexcept
{
  StepRoom& room = state.room;
  const auto n = static_cast<std::size_t>(model.nodes);
  for (std::size_t i = 0; i < n; ++i) room.force_W[i].setZero();
  addRodForces(model, state.position_W, room);
  addWallForces(model, state, state.position_W, room);
  addRimForces(model, state, state.position_W, room);

  // the base has inertia only where a spring holds it
  room.right[0].setZero();
  if (!base.isHeld) {
    const Eigen::Vector3d& at = state.position_W[0];
    room.right[0] = room.force_W[0] + room.force_W[1] - base.inertia * (at - base.free_W) -
                    base.grip * (at - base.gripped_W);
  }
  // every other node has its own, and the perilymph's drag
  for (std::size_t i = 2; i < n; ++i)
    room.right[i - 1] = room.force_W[i] - room.hold[i] * (state.position_W[i] - room.goal_W[i]);
  return leftOver(room.right);
}

void setStiffnessOfBalance(const InsertionModel& model, const Base& base, Compression compression,
                           StepRoom& room) noexcept
{
  const auto n = static_cast<std::size_t>(model.nodes);
  room.matrix.clear();
  addRodStiffness(model, compression, room);
  if (model.twists) addMaterialStiffness(model, room);
  addWallStiffness(room);
  addRimStiffness(room);
  for (std::size_t i = 2; i < n; ++i) room.matrix.diagonal[blockOf(i)] += uniform(room.hold[i]);
  if (base.isHeld)
    room.matrix.holdFirst();
  else
    room.matrix.diagonal[0] += uniform(base.inertia + base.grip);
}

}  // namespace perilymph::mechanics
