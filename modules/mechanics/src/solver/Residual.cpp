// SPDX-License-Identifier: BSD-3-Clause
#include "solver/Residual.h"

#include <algorithm>
#include <cmath>

#include "contact/Contact.h"
#include "contact/Guide.h"
#include "contact/Heights.h"
#include "contact/Rim.h"
#include "lanes/Lanes.h"
#include "rod/Rod.h"

namespace perilymph::mechanics {
namespace {

template <class T>
PERILYMPH_IN_LANES SymmetricBlock<T> uniform(const T& stiffness) noexcept
{
  return {stiffness, T{}, T{}, stiffness, T{}, stiffness};
}

/// Maximum and sum of squares over all blocks; NaN is propagated.
Residual normsOf(const std::vector<Eigen::Vector3d>& right) noexcept
{
  Four largest{}, sums{}, totals{};  // per axis
  withLanes([&]() PERILYMPH_KERNEL {
    Four maximum{}, sum{}, total{};
    forEachVector(right, [&](const Four& force) PERILYMPH_KERNEL {
      maximum = larger(maximum, magnitude(force));
      sum += force * force;
      total += force;
    });
    largest = maximum;
    sums = sum;
    totals = magnitude(total);
  });
  const double sum = sums[0] + sums[1] + sums[2];
  return {std::isfinite(sum) ? std::max({largest[0], largest[1], largest[2]}) : sum, sum,
          std::max({totals[0], totals[1], totals[2]})};
}

/// Every node but those of the base has its own inertia and the perilymph's drag.
void setUnbalanced(const std::vector<Eigen::Vector3d>& force_W, const NodeInertia& inertia,
                   const std::vector<Eigen::Vector3d>& position_W,
                   std::vector<Eigen::Vector3d>& right) noexcept
{
  const double* force = componentsOf(force_W);
  const double* position = componentsOf(position_W);
  const double* goal = componentsOf(inertia.goal_W);
  const double* hold = inertia.hold.data();
  double* unbalanced = componentsOf(right);
  inLanes(6, 3 * position_W.size(), [=](auto lane, std::size_t k) PERILYMPH_KERNEL {
    using T = decltype(lane);
    const T off = load<T>(position, k) - load<T>(goal, k);
    store(T(load<T>(force, k) - load<T>(hold, k) * off), unbalanced, k - 3);
  });
}

/// Inertia continues the motion, drag holds the node.
void setSprings(const InsertionModel& model, NodeInertia& inertia) noexcept
{
  inertia.timeStep = model.timeStep;
  const double inverseTimeStep = 1.0 / model.timeStep;
  for (std::size_t k = 6; k < inertia.hold.size(); ++k) {
    const double momentum = model.mass[k / 3] * inverseTimeStep;
    inertia.hold[k] = (momentum + model.drag[k / 3]) * inverseTimeStep;
    inertia.carried[k] = momentum / inertia.hold[k];
  }
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
  if (inertia.timeStep != model.timeStep) setSprings(model, inertia);
  const double* from = componentsOf(start.position_W);
  const double* velocity = componentsOf(state.velocity_W);
  const double* carried = inertia.carried.data();
  double* goal = componentsOf(inertia.goal_W);
  inLanes(6, 3 * state.position_W.size(), [=](auto lane, std::size_t k) PERILYMPH_KERNEL {
    using T = decltype(lane);
    store(T(load<T>(from, k) + load<T>(carried, k) * load<T>(velocity, k)), goal, k);
  });
}

Residual residual(const InsertionModel& model, InsertionState& state, const Base& base,
                  RodWorkspace& work) noexcept
{
  ++work.done.evaluations;
  setRodForces(model, state.position_W, work.section, work.rod, work.force_W);
  addWallForces(model, state, work.start, work.rod, work.contacts, work.friction, work.force_W);
  setHeights(state.position_W, model.openingCenter_W, model.entry.out_W, work.contacts.height);
  placeLaterTurnsBehind(state.track, work.contacts.height);
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

void assembleStiffness(const InsertionModel& model, const InsertionState& state, const Base& base,
                       Compression compression, RodWorkspace& work) noexcept
{
  const auto n = static_cast<std::size_t>(model.nodes);
  BandMatrix& matrix = work.system.matrix;
  setRodStiffness(model, compression, work.section, work.rod, work.joints, matrix);
  addWallStiffness(state, model.film.fraction > 0.0, work.contacts, work.friction, matrix);
  addRimStiffness(model, work.contacts, matrix);
  addGuideStiffness(model, work.guide, matrix);
  const double* hold = work.inertia.hold.data();
  inLanesInPlace(2, n, [&](auto lane, std::size_t i) PERILYMPH_KERNEL {
    using T = decltype(lane);
    SymmetricBlock<T> block = load<T>(matrix.diagonal, blockOf(i));
    block += uniform<T>(ofEachNode<T>(i, [=](std::size_t node) { return hold[3 * node]; }));
    store(block, matrix.diagonal, blockOf(i));
  });
  if (base.isHeld)
    matrix.holdFirst();
  else
    matrix.diagonal.add(0, uniform<double>(base.inertia + base.effectiveStiffness));
}

}  // namespace perilymph::mechanics
