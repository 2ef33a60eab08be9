// SPDX-License-Identifier: BSD-3-Clause
#include "rod/Step.h"

#include <algorithm>
#include <cstring>

#include "contact/Clearance.h"
#include "contact/OpenPartition.h"
#include "lanes/Lanes.h"
#include "rod/Material.h"
#include "rod/Relaxation.h"
#include "rod/Rod.h"
#include "rod/Wires.h"

namespace perilymph::mechanics {
namespace {

/// Initial guess: while the hand continues its motion, every node continues its own with its trend,
/// scaled by the same factor; otherwise every node slides along the array by the advance of the base.
/// A Newton step that remains from the last time step is made in addition.
void predict(const InsertionModel& model, InsertionState& state, const Drive& drive,
             const Base& base, RodWorkspace& work) noexcept
{
  const auto n = static_cast<std::size_t>(model.nodes);
  Eigen::Vector3d to_W = drive.handPosition_W;
  if (!base.isHeld)
    to_W = (base.inertia * base.free_W + base.effectiveStiffness * base.couplingTarget_W) /
           (base.inertia + base.effectiveStiffness);
  const double forward = (to_W - work.start.position_W[0]).dot(drive.handAxis_W);
  const double lastForward = model.timeStep * state.baseVelocity_W.dot(drive.handAxis_W);
  const double fraction = forward / lastForward;
  work.prediction.goesOn = !state.isSettling && fraction > 0.25 && fraction < 4.0;
  const double* start = componentsOf(work.start.position_W);
  double* position = componentsOf(state.position_W);
  if (work.prediction.goesOn) {
    const double* velocity = componentsOf(state.velocity_W);
    const double* trend = componentsOf(state.velocityTrend_W);
    const double duration = fraction * model.timeStep;
    inLanes(6, 3 * n, [=](auto lane, std::size_t k) PERILYMPH_KERNEL {
      using T = decltype(lane);
      const T expected = load<T>(velocity, k) + load<T>(trend, k);
      store(T(load<T>(start, k) + duration * expected), position, k);
    });
  } else {
    for (std::size_t i = 2; i < n; ++i)
      state.position_W[i] = work.start.position_W[i] + forward * work.rod.tangent_W[i - 1];
  }
  if (work.system.stepRemains) {
    const double* remaining = componentsOf(work.system.trial_W);
    inLanesInPlace(6, 3 * n, [=](auto lane, std::size_t k) PERILYMPH_KERNEL {
      using T = decltype(lane);
      store(T(load<T>(position, k) + load<T>(remaining, k - 3)), position, k);
    });
  }
  state.position_W[0] = to_W;
  state.position_W[1] = to_W + model.spacing * drive.handAxis_W;
  copy(state.position_W, work.prediction.position_W);
}

/// Corrects the trend of the velocities by the error of the prediction.
void learnTrend(const Prediction& prediction, double trendGain, double inverseTimeStep,
                InsertionState& state) noexcept
{
  const std::size_t components = 3 * state.position_W.size();
  double* trend = componentsOf(state.velocityTrend_W);
  if (state.isSettling || !prediction.goesOn) {
    std::fill_n(trend, components, 0.0);
    return;
  }
  const double* position = componentsOf(state.position_W);
  const double* expected = componentsOf(prediction.position_W);
  const double gain = trendGain * inverseTimeStep;
  inLanesInPlace(0, components, [=](auto lane, std::size_t k) PERILYMPH_KERNEL {
    using T = decltype(lane);
    const T error = load<T>(position, k) - load<T>(expected, k);
    store(T(load<T>(trend, k) + gain * error), trend, k);
  });
}

bool isSame(const std::vector<Eigen::Vector3d>& a, const std::vector<Eigen::Vector3d>& b) noexcept
{
  return std::memcmp(a.data(), b.data(), a.size() * sizeof a[0]) == 0;
}

/// Normal force at the end of a step, of a node or of four: it changes as in the step before, by at
/// most half. Where a contact begins or ended nothing is expected.
template <class T>
PERILYMPH_IN_LANES T expectedForce(const T& now, const T& before) noexcept
{
  const T half = 0.5 * now;
  const T change = smaller(larger(T(now - before), T(-half)), half);
  return oneOf((now > 0.0) & (before > 0.0), T(now + change), now);
}

/// Stores the state at the start of the step.
void remember(InsertionState& state, bool isOval, RodWorkspace& work) noexcept
{
  // what goes on from an unbalanced step tells nothing of the next one
  if (state.isSettling) {
    state.normalForceBefore = state.normalForce;
    state.rimForceBefore = state.rim.normalForce;
  }
  inLanesInPlace(0, state.normalForce.size(), [&](auto lane, std::size_t i) PERILYMPH_KERNEL {
    using T = decltype(lane);
    const T now = load<T>(state.normalForce, i);
    store(expectedForce(now, load<T>(state.normalForceBefore, i)), work.friction.pressedBefore, i);
    store(now, state.normalForceBefore, i);
  });
  copy(state.wallNormal_W, work.friction.normalBefore_W);
  std::ranges::fill(work.contacts.isKnown, no);
  if (isOval)
    for (SectionReach& section : work.contacts.section) section.isKnown = false;
  work.friction.rimPressedBefore = expectedForce(state.rim.normalForce, state.rimForceBefore);
  state.rimForceBefore = state.rim.normalForce;
  work.friction.rimNormalBefore_W = state.rim.normal_W;
}

}  // namespace

Step takeStep(const InsertionModel& model, InsertionState& state, const Drive& drive,
              double styletMoved, RodWorkspace& work) noexcept
{
  remember(state, model.isOval, work);
  findBone(model, state, work.contacts);
  if (state.partition.isRuptured()) findSides(model, state, work.contacts);
  setGuide(drive, state.base_W, work.guide);
  // the last forces of the step before were those here, unless the state was changed since
  if (!isSame(work.start.position_W, state.position_W)) {
    copy(state.position_W, work.start.position_W);
    setEdges(state.position_W, work.rod);
  }
  setRestShape(model, drive.handCurl_W, work.section, work.rod);
  if (styletMoved != 0.0 && model.styletMoment > 0.0)
    moveStylet(model, styletMoved, work.section, work.rod, state);
  if (work.section.holds) setHeldBend(model, state, work.section);
  if (model.twists)
    turnMaterial(model, drive.handCurl_W, work.section, state, work.rod, work.twist);
  const Base base = baseOf(model, state, drive);
  setHold(model, state, work.start, work.inertia);
  predict(model, state, drive, base, work);
  return {base, solveNewton(model, state, base, work)};
}

void commitStep(const InsertionModel& model, InsertionState& state, RodWorkspace& work) noexcept
{
  const bool keepsSections = model.isOval && model.parts.wall.sectionDelay.si() > 0.0;
  const double inverseTimeStep = 1.0 / model.timeStep;
  state.baseVelocity_W = inverseTimeStep * (state.position_W[0] - work.start.position_W[0]);
  state.base_W = state.position_W[0];
  const std::size_t n = state.position_W.size();
  const double* start = componentsOf(work.start.position_W);
  const double* position = componentsOf(state.position_W);
  double* velocity = componentsOf(state.velocity_W);
  inLanes(0, 3 * n, [=](auto lane, std::size_t k) PERILYMPH_KERNEL {
    using T = decltype(lane);
    store(T(inverseTimeStep * (load<T>(position, k) - load<T>(start, k))), velocity, k);
  });
  // what goes on in the next step has no momentum: nothing that is unbalanced adds energy
  if (state.isSettling) std::fill_n(velocity, 3 * n, 0.0);
  learnTrend(work.prediction, model.parts.solver.trendGain, inverseTimeStep, state);
  if (work.section.holds)
    state.readings.plasticWork += commitBends(model, work.section, work.rod, state);
  std::copy_n(componentsOf(work.friction.spring_W), 3 * n, componentsOf(state.frictionSpring_W));
  if (!state.frictionFilm_W.empty())
    std::copy_n(componentsOf(work.friction.film_W), 3 * n, componentsOf(state.frictionFilm_W));
  state.isSliding = work.friction.isSliding;
  inLanes(0, n, [&](auto lane, std::size_t i) PERILYMPH_KERNEL {
    using T = decltype(lane);
    store(T(inverseTimeStep * load<T>(work.friction.slip, i)), state.slipSpeed, i);
  });
  if (keepsSections) state.section = work.contacts.section;
  keepClearance(work.contacts, state);
  state.rim = work.contacts.rim;
  copy(state.position_W, work.start.position_W);
}

}  // namespace perilymph::mechanics
