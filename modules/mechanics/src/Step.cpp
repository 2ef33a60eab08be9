#include "Step.h"

#include "Descent.h"
#include "contact/Clearance.h"
#include "rod/Material.h"
#include "rod/Rod.h"

namespace perilymph::mechanics {
namespace {

/// First guess: while the hand goes on as it did, every node goes on as it did, faster or slower by
/// the same share; else every node slides along the array by as much as the base advances.
void predict(const InsertionModel& model, InsertionState& state, const Drive& drive,
             const Base& base, Way way) noexcept
{
  const auto n = static_cast<std::size_t>(model.nodes);
  StepRoom& room = state.room;
  Eigen::Vector3d to_W = drive.handPosition_W;
  if (!base.isHeld)
    to_W = (base.inertia * base.free_W + base.grip * base.gripped_W) / (base.inertia + base.grip);
  const double forward = (to_W - room.before_W[0]).dot(drive.handAxis_W);
  const double lastForward = room.timeStep * state.baseVelocity_W.dot(drive.handAxis_W);
  const double share = forward / lastForward;
  const bool goesOn = way == Way::quick && share > 0.25 && share < 4.0;
  for (std::size_t i = 2; i < n; ++i) {
    const Eigen::Vector3d motion =
        goesOn ? Eigen::Vector3d(share * room.timeStep * state.velocity_W[i])
               : Eigen::Vector3d(forward * room.edge[i - 1].tangent_W);
    state.position_W[i] = room.before_W[i] + motion;
  }
  state.position_W[0] = to_W;
  state.position_W[1] = to_W + model.spacing * drive.handAxis_W;
}

/// What the step starts from.
void remember(InsertionState& state) noexcept
{
  StepRoom& room = state.room;
  for (std::size_t i = 0; i < state.position_W.size(); ++i) {
    room.before_W[i] = state.position_W[i];
    room.trackBefore[i] = state.track[i];
    room.curlBefore_W[i] = state.curl_W[i];
    room.pressedBefore[i] = state.normalForce[i];
    room.normalBefore_W[i] = state.wallNormal_W[i];
    room.section[i].isKnown = false;
    room.isKnown[i] = 0;
  }
  room.rimPressedBefore = state.rim.normalForce;
  room.rimNormalBefore_W = state.rim.normal_W;
}

}  // namespace

Step tryStep(const InsertionModel& model, InsertionState& state, const Drive& drive,
             double timeStep, Way way) noexcept
{
  StepRoom& room = state.room;
  room.timeStep = timeStep;
  remember(state);
  findBone(model, state);
  setRestShape(model, state, drive.handCurl_W, room);
  if (model.twists) turnMaterial(model, state, drive.handCurl_W, room);
  const Base base = baseOf(model, state, drive);
  setHold(model, state);
  predict(model, state, drive, base, way);
  if (way == Way::downhill) return {base, descend(model, state, base, {})};
  return {base, settle(model, state, base)};
}

void keepStep(InsertionState& state) noexcept
{
  const StepRoom& room = state.room;
  const double perTime = 1.0 / room.timeStep;
  state.baseVelocity_W = perTime * (state.position_W[0] - room.before_W[0]);
  state.base_W = state.position_W[0];
  for (std::size_t i = 0; i < state.position_W.size(); ++i) {
    state.velocity_W[i] = perTime * (state.position_W[i] - room.before_W[i]);
    state.frictionSpring_W[i] = room.frictionSpring_W[i];
    state.isSliding[i] = room.isSliding[i];
    state.slipSpeed[i] = perTime * room.slip[i];
  }
  keepClearance(state);
  state.rim = room.rim;
}

void undoStep(InsertionState& state) noexcept
{
  const StepRoom& room = state.room;
  for (std::size_t i = 0; i < state.position_W.size(); ++i) {
    state.position_W[i] = room.before_W[i];
    state.track[i] = room.trackBefore[i];
    state.curl_W[i] = room.curlBefore_W[i];
    state.normalForce[i] = room.pressedBefore[i];
    state.wallNormal_W[i] = room.normalBefore_W[i];
  }
  state.factors.forget();
}

}  // namespace perilymph::mechanics
