#include "perilymph/mechanics/advance.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "Newton.h"
#include "contact/Clearance.h"
#include "contact/Contact.h"
#include "points/advancePoints.h"
#include "rod/Rod.h"

namespace perilymph::mechanics {
namespace {

/// First guess: while the hand goes on as it did, every node goes on as it did, faster or slower by
/// the same share; else every node slides along the array by as much as the base advances.
void predict(const InsertionModel& model, InsertionState& state, const Drive& drive,
             const Base& base) noexcept
{
  const auto n = static_cast<std::size_t>(model.nodes);
  StepRoom& room = state.room;
  Eigen::Vector3d to_W = drive.handPosition_W;
  if (!base.isHeld)
    to_W = (base.inertia * base.free_W + base.grip * base.gripped_W) / (base.inertia + base.grip);
  const double forward = (to_W - room.before_W[0]).dot(drive.handAxis_W);
  const double lastForward = model.timeStep * state.baseVelocity_W.dot(drive.handAxis_W);
  const double share = forward / lastForward;
  const bool goesOn = share > 0.25 && share < 4.0;
  for (std::size_t i = 2; i < n; ++i) {
    const Eigen::Vector3d motion =
        goesOn ? Eigen::Vector3d(share * model.timeStep * state.velocity_W[i])
               : Eigen::Vector3d(forward * room.edge[i - 1].tangent_W);
    state.position_W[i] = room.before_W[i] + motion;
  }
  state.position_W[0] = to_W;
  state.position_W[1] = to_W + model.spacing * drive.handAxis_W;
}

/// Length of array past the plane of the opening.
double depthOf(const InsertionModel& model, const InsertionState& state) noexcept
{
  const auto inside = [&](std::size_t i) {
    return (model.entry.origin_W - state.position_W[i]).dot(model.entry.out_W);
  };
  double after = inside(state.position_W.size() - 1);
  if (!(after > 0.0)) return 0.0;
  for (std::size_t i = state.position_W.size() - 1; i-- > 0;) {
    const double before = inside(i);
    if (before <= 0.0) {
      const double share = after / (after - before);
      return model.fromTip[i + 1] + share * model.spacing;
    }
    after = before;
  }
  return model.fromTip[0];
}

/// What the rest of the program wants to know of the step.
void read(const InsertionModel& model, InsertionState& state, const Drive& drive, const Base& base,
          const Settled& settled) noexcept
{
  const StepRoom& room = state.room;
  Readings& r = state.readings;
  r.iterations = settled.iterations;
  r.residual = settled.left.worst;
  // the hand holds nodes 0 and 1; in spring coupling it holds them through the spring
  const Eigen::Vector3d onBase_W = room.force_W[0] + room.force_W[1];
  r.handForce_W =
      base.isHeld ? onBase_W : Eigen::Vector3d(base.grip * (state.base_W - base.gripped_W));
  r.handTorque_W = (model.spacing * drive.handAxis_W).cross(room.force_W[1]);
  r.axialForce = r.handForce_W.dot(model.entry.out_W);
  r.speed = -state.baseVelocity_W.dot(model.entry.out_W);
  r.depth = depthOf(model, state);
  r.angularDepth = r.depth > 0.0 ? std::max(state.track.back().angle, 0.0) : 0.0;
  r.rimForce = state.rim.normalForce;
  r.contacts = 0;
  r.wallForceMax = r.wallForceTotal = r.membraneForce = 0.0;
  for (std::size_t i = 0; i < state.normalForce.size(); ++i) {
    const double force = state.normalForce[i];
    if (!(force > 0.0)) continue;
    ++r.contacts;
    r.wallForceTotal += force;
    r.wallForceMax = std::max(r.wallForceMax, force);
    r.membraneForce += state.membraneForce[i];
  }
  const double sum = r.handForce_W.x() + r.handForce_W.y() + r.handForce_W.z() +
                     state.position_W.back().x() + state.position_W.back().y() +
                     state.position_W.back().z() + settled.left.squares;
  r.isFinite = std::isfinite(sum);
}

}  // namespace

void advance(const InsertionModel& model, InsertionState& state, const Drive& drive) noexcept
{
  if (model.points) return advancePoints(model, state, drive);
  StepRoom& room = state.room;
  const std::size_t n = state.position_W.size();

  // what this step starts from
  for (std::size_t i = 0; i < n; ++i) room.before_W[i] = state.position_W[i];
  state.styletWithdrawal = drive.styletWithdrawal;
  setStiffness(model, drive.styletWithdrawal, room);
  setRestShape(model, state, drive.handCurl_W, room);
  const Base base = baseOf(model, state, drive);

  // predict the rod, then correct it against the wall
  predict(model, state, drive, base);
  const Settled settled = settle(model, state, base);

  // what the next step starts from
  const double perTime = 1.0 / model.timeStep;
  state.baseVelocity_W = perTime * (state.position_W[0] - room.before_W[0]);
  state.base_W = state.position_W[0];
  for (std::size_t i = 0; i < n; ++i) {
    state.velocity_W[i] = perTime * (state.position_W[i] - room.before_W[i]);
    state.frictionSpring_W[i] = room.frictionSpring_W[i];
    state.isSliding[i] = room.isSliding[i];
    state.slipSpeed[i] = perTime * room.slip[i];
  }
  keepClearance(state);
  state.rim = room.rim;
  ++state.tick;
  read(model, state, drive, base, settled);
}

}  // namespace perilymph::mechanics
