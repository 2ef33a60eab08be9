// SPDX-License-Identifier: BSD-3-Clause
#include "rod/advanceRod.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <span>

#include "contact/Heights.h"
#include "contact/PartitionRupture.h"
#include "rod/Rod.h"
#include "rod/Step.h"

namespace perilymph::mechanics {
namespace {

// Faster than a hand pulls a stylet (choice, low).
constexpr double fastestStylet = 0.1;  // [m/s]

/// Wrench of the array on the hand.
struct Wrench {
  Eigen::Vector3d force_W = Eigen::Vector3d::Zero();   ///< [N]
  Eigen::Vector3d torque_W = Eigen::Vector3d::Zero();  ///< [N.m]
};

/// The hand holds nodes 0 and 1; with spring coupling, through the spring.
Wrench wrenchOf(const InsertionModel& model, const InsertionState& state, const Drive& drive,
                const Base& base, const RodWorkspace& work) noexcept
{
  Wrench wrench;
  wrench.force_W =
      base.isHeld
          ? Eigen::Vector3d(work.force_W[0] + work.force_W[1])
          : Eigen::Vector3d(base.effectiveStiffness * (state.base_W - base.couplingTarget_W));
  wrench.torque_W = (model.spacing * drive.handAxis_W).cross(work.force_W[1]) +
                    (model.twists ? work.rod.twistTorque : 0.0) * drive.handAxis_W;
  return wrench;
}

/// Length of array past the plane of the opening [m].
///
/// @param height  Of each node above the opening's center at the last forces.
double depthOf(const InsertionModel& model, const InsertionState& state,
               std::vector<double>& height) noexcept
{
  if (model.openingCenter_W != model.entry.origin_W)
    setHeights(state.position_W, model.entry.origin_W, model.entry.out_W, height);
  const auto behind = [&](std::size_t i) {
    return anatomy::behindOpening(model.entry, state.position_W[i], state.track[i]);
  };
  const std::size_t tip = state.position_W.size() - 1;
  if (!(behind(tip) > 0.0)) return 0.0;
  for (std::size_t i = tip; i-- > 0;) {
    if (height[i] < 0.0) continue;  // a later turn that the plane cuts is behind it, too
    const double before = behind(i), after = behind(i + 1);
    if (before <= 0.0) return model.fromTip[i + 1] + after / (after - before) * model.spacing;
  }
  return model.fromTip[0];
}

/// Fills the readings of the step.
void read(const InsertionModel& model, InsertionState& state, const Wrench& wrench,
          const SolveResult& result, RodWorkspace& work) noexcept
{
  Readings& r = state.readings;
  r.evaluations = work.done.evaluations;
  r.factorizations = work.done.factorizations;
  r.iterations = result.iterations;
  r.residual = result.residual.maxNorm;
  r.handForce_W = wrench.force_W;
  r.handTorque_W = wrench.torque_W;
  r.axialForce = r.handForce_W.dot(model.entry.out_W);
  r.speed = -state.baseVelocity_W.dot(model.entry.out_W);
  r.depth = depthOf(model, state, work.contacts.height);
  r.angularDepth = r.depth > 0.0 ? std::max(state.track.back().angle, 0.0) : 0.0;
  r.rimForce = state.rim.normalForce;
  r.contacts = 0;
  const double *normalForce = state.normalForce.data(), *onMembrane = state.membraneForce.data();
  double total = 0.0, largest = 0.0, membrane = 0.0;
  for (const std::size_t i : std::span(work.contacts.touching).first(work.contacts.touches)) {
    const double force = normalForce[i];
    if (!(force > 0.0)) continue;
    ++r.contacts;
    total += force;
    largest = std::max(largest, force);
    membrane += onMembrane[i];
  }
  r.wallForceTotal = total;
  r.wallForceMax = largest;
  r.membraneForce = membrane;
  const double sum = r.handForce_W.x() + r.handForce_W.y() + r.handForce_W.z() +
                     state.position_W.back().x() + state.position_W.back().y() +
                     state.position_W.back().z() + result.residual.squaredNorm;
  r.isFinite = std::isfinite(sum);
}

}  // namespace

void advanceRod(const InsertionModel& model, InsertionState& state, const Drive& drive,
                RodWorkspace& work) noexcept
{
  // the release of a stylet pulled at once, or of a precurved array, is spread over some time
  const double pulled = fastestStylet * model.timeStep;
  const double styletMoved =
      std::clamp(drive.styletWithdrawal - state.styletWithdrawal, -pulled, pulled);
  state.styletWithdrawal += styletMoved;
  const double released =
      std::min(static_cast<double>(state.tick + 1) * model.timeStep / releaseTime, 1.0);
  setStiffness(model, state.styletWithdrawal, released, work.section);

  work.done = {};
  const Step step = takeStep(model, state, drive, styletMoved, work);
  state.isSettling = !(step.result.residual.maxNorm <= model.parts.solver.settledForce);
  commitStep(model, state, work);
  const Wrench wrench = wrenchOf(model, state, drive, step.base, work);
  ++state.tick;
  read(model, state, wrench, step.result, work);
  if (state.isSettling) return;
  const PartitionContact contact = contactWithPartition(model, state, work.contacts);
  state.readings.partitionForce = contact.force;
  if (model.partition) rupturePartition(*model.partition, contact, state);
}

}  // namespace perilymph::mechanics
