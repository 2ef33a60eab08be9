// SPDX-License-Identifier: BSD-3-Clause
#include "solver/Residual.h"

#include <algorithm>
#include <cmath>

#include "contact/Contact.h"
#include "contact/Guide.h"
#include "contact/Heights.h"
#include "contact/Rim.h"
#include "lanes/Lanes.h"
#include "rod/Material.h"

namespace perilymph::mechanics {
namespace {

SymmetricBlock<double> uniform(double stiffness) noexcept
{
  return {stiffness, 0.0, 0.0, stiffness, 0.0, stiffness};
}

/// Maximum and sum of squares over all blocks; NaN is propagated.
Residual normsOf(const std::vector<Eigen::Vector3d>& right) noexcept
{
  Four largest{}, sums{};  // per axis
  withLanes([&]() PERILYMPH_KERNEL {
    Four most{}, sum{};
    for (std::size_t i = 0; i < right.size(); ++i) {
      const Four force = axesOf(right, i);
      most = larger(most, force < 0.0 ? -force : force);
      sum += force * force;
    }
    largest = most;
    sums = sum;
  });
  const double sum = sums[0] + sums[1] + sums[2];
  return {std::isfinite(sum) ? std::max({largest[0], largest[1], largest[2]}) : sum, sum};
}

/// Every node but those of the base has its own inertia and the perilymph's drag.
void setUnbalanced(const std::vector<Eigen::Vector3d>& force_W, const NodeInertia& inertia,
                   const std::vector<Eigen::Vector3d>& position_W,
                   std::vector<Eigen::Vector3d>& right) noexcept
{
  inLanes(2, position_W.size(), [&](auto lane, std::size_t i) PERILYMPH_KERNEL {
    using T = decltype(lane);
    const Triple<T> off = load<T>(position_W, i) - load<T>(inertia.goal_W, i);
    store(load<T>(force_W, i) - load<T>(inertia.hold, i) * off, right, i - 1);
  });
}

}  // namespace

Base baseOf(const InsertionModel& model, const InsertionState& state, const Drive& drive) noexcept
{
  const double dt = model.timeStep;
  Base base{};
  base.isHeld = drive.coupling == Coupling::rigid;
  base.inertia = model.baseMass / (dt * dt);
  base.effectiveStiffness = drive.couplingStiffness + drive.couplingDamping / dt;
  base.free_W = state.base_W + dt * state.baseVelocity_W;
  base.couplingTarget_W = drive.handPosition_W;
  if (base.effectiveStiffness > 0.0)
    base.couplingTarget_W = (drive.couplingStiffness * drive.handPosition_W +
                             drive.couplingDamping * (state.base_W / dt + drive.handVelocity_W)) /
                            base.effectiveStiffness;
  return base;
}

void setHold(const InsertionModel& model, const InsertionState& state, const StepStart& start,
             NodeInertia& inertia) noexcept
{
  const double inverseTimeStep = 1.0 / model.timeStep;
  inLanes(2, state.position_W.size(), [&](auto lane, std::size_t i) PERILYMPH_KERNEL {
    using T = decltype(lane);
    const T momentum = load<T>(model.mass, i) * inverseTimeStep;
    const T hold = (momentum + load<T>(model.drag, i)) * inverseTimeStep;
    store(hold, inertia.hold, i);
    // rest position: inertia continues the motion, drag holds the node
    const T weight = momentum / hold;
    store(load<T>(start.position_W, i) + weight * load<T>(state.velocity_W, i), inertia.goal_W, i);
  });
}

Residual residual(const InsertionModel& model, InsertionState& state, const Base& base,
                  RodWorkspace& work) noexcept
{
  ++work.done.evaluations;
  setRodForces(model, state.position_W, work.section, work.rod, work.force_W);
  addWallForces(model, state, work.start, work.rod, work.contacts, work.friction, work.force_W);
  setHeights(state.position_W, model.openingCenter_W, model.entry.out_W, work.contacts.height);
  addRimForces(model, state, work.start, work.friction, work.contacts, work.force_W);
  addGuideForces(model, state.position_W, work.contacts.height, work.guide, work.force_W);

  // the base has inertia only with spring coupling
  work.system.right[0].setZero();
  if (!base.isHeld) {
    const Eigen::Vector3d& at = state.position_W[0];
    work.system.right[0] = work.force_W[0] + work.force_W[1] - base.inertia * (at - base.free_W) -
                           base.effectiveStiffness * (at - base.couplingTarget_W);
  }
  setUnbalanced(work.force_W, work.inertia, state.position_W, work.system.right);
  return normsOf(work.system.right);
}

void assembleStiffness(const InsertionModel& model, const Base& base, Compression compression,
                       RodWorkspace& work) noexcept
{
  const auto n = static_cast<std::size_t>(model.nodes);
  work.system.matrix.clear();
  BandMatrix& matrix = work.system.matrix;
  addRodStiffness(model, compression, work.section, work.rod, matrix);
  if (model.twists) addMaterialStiffness(model, work.section, work.rod, matrix);
  addWallStiffness(work.contacts, work.friction, matrix);
  addRimStiffness(model, work.contacts, matrix);
  addGuideStiffness(model, work.guide, matrix);
  for (std::size_t i = 2; i < n; ++i)
    work.system.matrix.diagonal[blockOf(i)] += uniform(work.inertia.hold[i]);
  if (base.isHeld)
    work.system.matrix.holdFirst();
  else
    work.system.matrix.diagonal[0] += uniform(base.inertia + base.effectiveStiffness);
}

}  // namespace perilymph::mechanics
