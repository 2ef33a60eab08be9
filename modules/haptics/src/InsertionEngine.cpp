// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/haptics/InsertionEngine.h"
#include "PartitionOutput.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "checkedSettings.h"
#include "perilymph/foundation/Four.h"

namespace perilymph::haptics {

namespace {

// A thousandth of the forces of an insertion (0.1 N); fifty times the solver's tolerance.
constexpr double maxResidual = 1e-4;  // [N]
// Far below measurable depths; above rounding errors.
constexpr double arrived = 1e-9;  // [m]
constexpr double infinitelyFar = std::numeric_limits<double>::infinity();

std::array<double, 3> asArray(const Eigen::Vector3d& vector) noexcept
{
  return {vector[0], vector[1], vector[2]};
}

bool isFiniteVector(const Eigen::Vector3d& vector) noexcept
{
  return std::isfinite(vector[0]) && std::isfinite(vector[1]) && std::isfinite(vector[2]);
}

void asFloats(const double* values, std::size_t count, float* to) noexcept
{
  withLanes([&]() PERILYMPH_KERNEL {
    constexpr std::size_t together = 8;
    std::size_t i = 0;
    for (; i + together <= count; i += together)
      for (std::size_t k = 0; k < together; ++k) to[i + k] = static_cast<float>(values[i + k]);
    for (; i < count; ++i) to[i] = static_cast<float>(values[i]);
  });
}

BasePose startOf(const mechanics::InsertionModel& model) noexcept
{
  return {model.startBase_W, model.startAxis_W, model.startCurl_W};
}

}  // namespace

InsertionEngine::InsertionEngine(std::shared_ptr<const mechanics::InsertionModel> model,
                                 EngineSettings settings)
    : model_(checkedModel(std::move(model))),
      settings_(checkedSettings(settings)),
      state_(*model_),
      validator_(model_->timeStep, settings_.samplePeriod),
      registration_(model_->entry,
                    settings_.pushesAlongOpening ? Eigen::Vector3d(-model_->entry.out_W)
                                                 : model_->startAxis_W,
                    settings_.motionScale),
      safety_(settings_.safety, model_->timeStep),
      startDepth_(std::max(0.0, model_->parts.startInside.si())),
      base_(startOf(*model_)),
      stylet_(settings_.styletSpeed, settings_.styletHoldDepth),
      detector_(*model_, settings_.stopForce),
      rest_({settings_.restAfter, settings_.restMotion, settings_.restHandMotion}, model_->timeStep)
{
  updateOutput();
}

TickOutput InsertionEngine::tick(const device::DeviceSample& sample,
                                 const CommandList& commands) noexcept
{
  if (rest_.isOn()) {
    if (!endsRest(sample, commands)) {
      stayAtRest();
      return output_;
    }
    rest_.end();
  }
  output_.status = allWell;
  const std::uint32_t count = std::min<std::uint32_t>(commands.count, maxCommandsPerTick);
  for (std::uint32_t i = 0; i < count; ++i) applyCommand(commands.items[i]);

  const HandState& hand = validator_.take(sample);
  validate(hand, output_.status);

  // After an overflow the state is kept for inspection.
  if (workflow_ != Workflow::idle && isFinite()) moveMechanics(hand);
  if (isStopped_) output_.status |= stopped;
  output_.status |= bitOf(end_);
  updateOutput();
  peak_.follow(output_);

  // The force is computed after the mechanics, so that it belongs to this tick's pose.
  const Eigen::Vector3d force_D =
      registration_.toDevice(settings_.forceScale * state_.readings.handForce_W);
  const Eigen::Vector3d shown_D = safety_.show(force_D, conditionOf(hand), output_.status);
  output_.wrench_D.force_D = asArray(shown_D);
  noteRest(hand);
  ++ticks_;
  return output_;
}

bool InsertionEngine::endsRest(const device::DeviceSample& sample,
                               const CommandList& commands) noexcept
{
  // Nothing of the samples during the rest is known to a replay. A hand that holds on is where it
  // was at its beginning.
  if (!rest_.isHeld()) validator_ = SampleValidator(model_->timeStep, settings_.samplePeriod);
  if (commands.count > 0) return true;
  if (workflow_ == Workflow::fault) return false;
  if (sample.isValid == 0) return true;
  if (rest_.isHeld()) return rest_.isLeftBy(sample);
  if (workflow_ == Workflow::idle || isStopped_) return false;
  return (sample.buttons & device::graspButton) != 0;
}

/// All values are those of the tick before the rest, in which the rendered force was zero, or
/// steady at a hand that holds on.
void InsertionEngine::stayAtRest() noexcept
{
  output_.status |= resting;
  ++ticks_;
}

/// Counts the ticks without motion and force; the next tick rests when there are enough.
void InsertionEngine::noteRest(const HandState& hand) noexcept
{
  const bool isGrasped = hand.isHeld && !isStopped_ && workflow_ != Workflow::fault;
  constexpr std::uint32_t changing = staleSample | forceSlewed | rampingIn | passivityActed;
  Rest::Condition now;
  now.isSteady = isGrasped ? (output_.status & changing) == 0 : safety_.isZero();
  now.isInserting = workflow_ == Workflow::inserting;
  now.mayRest = stylet_.isAtRest() && (isGrasped || now.isSteady);
  now.isHeld = isGrasped;
  now.hasBegun = hasBegun_;
  now.tip_W = state_.position_W.back();
  now.hand_D = hand.position_D;
  rest_.note(now);
}

void InsertionEngine::applyCommand(const Command& command) noexcept
{
  switch (command.kind) {
    case Command::Kind::none:
      break;
    case Command::Kind::arm:
      transition(WorkflowEvent::arm);
      break;
    case Command::Kind::withdraw:
      startWithdrawing();
      break;
    case Command::Kind::stop:
      stop();
      break;
    case Command::Kind::resume:
      isStopped_ = false;
      break;
    case Command::Kind::pullStylet:
      // A withdrawn stylet is never pushed back into the array.
      if (workflow_ != Workflow::idle && workflow_ != Workflow::fault && command.value >= 0.0)
        stylet_.pullTo(*model_, command.value);
      break;
  }
}

void InsertionEngine::transition(WorkflowEvent event) noexcept
{
  const Workflow before = workflow_;
  workflow_ = next(before, event);
  if (workflow_ == before || !isFinite()) return;
  // The base is held where the last tick left it and continues from there.
  base_.position_W = state_.base_W;
  if (workflow_ != Workflow::inserting) return;
  needsAnchor_ = true;
  // The spring starts in equilibrium with the force it takes over: hand - base = -F / K.
  if (settings_.coupling == mechanics::Coupling::spring)
    base_.position_W -= state_.readings.handForce_W / couplingStiffness();
}

void InsertionEngine::startWithdrawing() noexcept
{
  const bool isOut = workflow_ == Workflow::idle || workflow_ == Workflow::armed;
  if (isOut || workflow_ == Workflow::fault || isWithdrawn_) return;
  isWithdrawing_ = true;
  transition(WorkflowEvent::withdraw);
}

void InsertionEngine::stop() noexcept
{
  isStopped_ = true;
  transition(WorkflowEvent::release);
  stylet_.stop();
}

void InsertionEngine::validate(const HandState& hand, std::uint32_t& status) noexcept
{
  if (hand.isRejected) status |= sampleRejected;
  if (hand.hasJumped) {
    status |= handJumped;
    needsAnchor_ = true;
  }
  if (hand.isLost) {
    status |= deviceLost;
    transition(WorkflowEvent::error);
  }
  if (!isFinite()) transition(WorkflowEvent::error);

  // A stale hand cannot grasp, and after a stop none can.
  const bool holds = hand.isHeld && !hand.isStale && !isStopped_;
  if (holds) transition(WorkflowEvent::grasp);
  if (!hand.isHeld) transition(WorkflowEvent::release);
}

HandCondition InsertionEngine::conditionOf(const HandState& hand) const noexcept
{
  HandCondition condition;
  condition.moved_D = hand.moved_D;
  const bool isAtWork = workflow_ == Workflow::inserting || workflow_ == Workflow::finished;
  condition.isHeld = hand.isHeld && isAtWork && !isStopped_;
  condition.isStale = hand.isStale;
  const bool isEnded = end_ != InsertionEnd::none && end_ != InsertionEnd::stoppedByResistance;
  condition.hasFault = workflow_ == Workflow::fault || isEnded;
  condition.hasJumped = hand.hasJumped;
  condition.distance = hand.position_D.norm();
  return condition;
}

void InsertionEngine::moveMechanics(const HandState& hand) noexcept
{
  if (hasBegun_) ++ticksSinceBegin_;
  if (workflow_ == Workflow::inserting) hasBegun_ = true;
  stylet_.step(*model_, state_.readings.depth);

  const mechanics::Drive drive = workflow_ == Workflow::inserting ? follow(hand) : hold();
  mechanics::advance(*model_, state_, drive);
  output_.device_W = asArray(drive.handPosition_W);

  if (!isFinite()) return transition(WorkflowEvent::error);
  if (state_.readings.residual > maxResidual) output_.status |= notConverged;
  if (workflow_ == Workflow::inserting) noteEnd();
  if (workflow_ == Workflow::inserting) noteArrival();
}

/// The first event is how the insertion ended; the array may then be withdrawn, without force.
void InsertionEngine::noteEnd() noexcept
{
  if (end_ != InsertionEnd::none) return;
  end_ = detector_.detect(*model_, state_, isWithdrawing_);
  if (end_ != InsertionEnd::none) transition(WorkflowEvent::arrive);
}

mechanics::Drive InsertionEngine::hold() const noexcept
{
  mechanics::Drive drive;
  drive.handPosition_W = base_.position_W;
  drive.handAxis_W = base_.axis_W;
  drive.handCurl_W = base_.curl_W;
  drive.styletWithdrawal = stylet_.withdrawal();
  drive.coupling = mechanics::Coupling::rigid;
  return drive;
}

/// Coupling stiffness or damping reduced to what the device can render at the hand, where it is
/// multiplied by the force and motion scales.
double InsertionEngine::softened(double asked, double maximum) const noexcept
{
  const double atHand = settings_.forceScale * settings_.motionScale * asked;
  return atHand <= maximum ? asked : asked * (maximum / atHand);
}

double InsertionEngine::couplingStiffness() const noexcept
{
  return softened(settings_.couplingStiffness, settings_.maxStiffness);
}

mechanics::Drive InsertionEngine::follow(const HandState& hand) noexcept
{
  if (needsAnchor_) registration_.anchor(hand, base_);
  needsAnchor_ = false;

  const Eigen::Vector3d before_W = base_.position_W;
  base_ = registration_.pose(hand);
  const Eigen::Vector3d inward_W = registration_.inward_W();
  const double toBone = distanceToBone(*model_, state_.base_W, inward_W);
  const double toStop =
      isWithdrawing_ ? infinitelyFar : std::max(0.0, settings_.stopTravel - travel());
  const double remaining = std::min(toStop, toBone);

  mechanics::Drive drive;
  if (settings_.coupling == mechanics::Coupling::spring) {
    const double ahead = inward_W.dot(state_.baseVelocity_W) * model_->timeStep;
    // Two ticks before the stop, because the base may still accelerate.
    if (2.0 * ahead < remaining) {
      drive = hold();
      drive.coupling = mechanics::Coupling::spring;
      drive.couplingStiffness = couplingStiffness();
      drive.couplingDamping = softened(settings_.couplingDamping, settings_.maxDamping);
      if (drive.couplingStiffness < settings_.couplingStiffness) output_.status |= couplingSoftened;
      drive.handVelocity_W = registration_.toCochlea(registration_.motionScale() * hand.velocity_D);
      return drive;
    }
    // Near the stop the base is moved directly, at its speed, so that it does not overshoot.
    base_.position_W = state_.base_W + std::min(ahead, remaining) * inward_W;
  }

  // Limit the motion of one tick to the stop.
  const double ahead = inward_W.dot(base_.position_W - state_.base_W);
  if (ahead > remaining) base_.position_W -= (ahead - remaining) * inward_W;
  drive = hold();
  const Eigen::Vector3d from_W =
      settings_.coupling == mechanics::Coupling::spring ? state_.base_W : before_W;
  drive.handVelocity_W = (base_.position_W - from_W) / model_->timeStep;
  return drive;
}

void InsertionEngine::noteArrival() noexcept
{
  if (!isWithdrawing_ && travel() >= settings_.stopTravel - arrived)
    transition(WorkflowEvent::arrive);
  if (isWithdrawing_ && travel() <= arrived) {
    isWithdrawing_ = false;
    isWithdrawn_ = true;
    transition(WorkflowEvent::arrive);
  }
}

double InsertionEngine::travel() const noexcept { return state_.readings.depth - startDepth_; }

bool InsertionEngine::isFinite() const noexcept
{
  return state_.readings.isFinite && isFiniteVector(state_.readings.handForce_W) &&
         isFiniteVector(state_.base_W) && std::isfinite(state_.readings.depth);
}

void InsertionEngine::updateOutput() noexcept
{
  output_.workflow = workflow_;
  output_.time = static_cast<double>(ticksSinceBegin_) * model_->timeStep;
  output_.styletWithdrawal = stylet_.withdrawal();
  if (!isFinite()) {
    output_.status |= notFinite;
    return;  // the values of the last valid tick are kept
  }
  const mechanics::Readings& now = state_.readings;
  output_.contacts = static_cast<std::uint32_t>(now.contacts);
  output_.iterations = static_cast<std::uint32_t>(now.iterations);
  output_.travel = travel();
  output_.depth = now.depth;
  output_.speed = now.speed;
  output_.angularDepth = now.angularDepth;
  output_.axialForce = now.axialForce;
  output_.force_W = asArray(now.handForce_W);
  output_.tip_W = asArray(state_.position_W.back());
  output_.proxy_W = asArray(state_.base_W);
  output_.wallForceMax = now.wallForceMax;
  output_.membraneForce = now.membraneForce;
  output_.partitionForce = now.partitionForce;
  if (model_->parts.array.yields()) output_.plasticWork = now.plasticWork;
  output_.residual = now.residual;
  notePartition(*model_, state_.partition, output_);
}

void InsertionEngine::fill(Snapshot& snapshot) const noexcept
{
  snapshot.tick = ticks_ == 0 ? 0 : ticks_ - 1;
  snapshot.output = output_;
  snapshot.peak = peak_;
  snapshot.baseAxis_W = asArray(base_.axis_W);
  const bool isSpring = settings_.coupling == mechanics::Coupling::spring;
  snapshot.couplingStiffness = isSpring ? couplingStiffness() : 0.0;
  snapshot.nodes = static_cast<std::uint32_t>(std::min(model_->nodes, mechanics::maxNodes));
  if (!isFinite()) return;
  noteRuptures(state_.partition, snapshot);
  const std::size_t nodes = snapshot.nodes;
  asFloats(state_.position_W.front().data(), 3 * nodes, snapshot.node_W.front().data());
  asFloats(state_.wallForce_W.front().data(), 3 * nodes, snapshot.wallForce_W.front().data());
  asFloats(state_.normalForce.data(), nodes, snapshot.normalForce.data());
}

std::uint64_t InsertionEngine::fingerprint() const noexcept
{
  Hash hash;
  hash.add(state_.fingerprint());
  hash.add(workflow_);
  validator_.addTo(hash);
  registration_.addTo(hash);
  safety_.addTo(hash);
  for (int i = 0; i < 3; ++i) {
    hash.add(base_.position_W[i]);
    hash.add(base_.axis_W[i]);
    hash.add(base_.curl_W[i]);
  }
  stylet_.addTo(hash);
  hash.add(needsAnchor_);
  hash.add(isWithdrawing_);
  hash.add(isWithdrawn_);
  hash.add(isStopped_);
  rest_.addTo(hash);
  hash.add(hasBegun_);
  hash.add(ticksSinceBegin_);
  detector_.addTo(hash);
  hash.add(end_);
  return hash.value();
}

}  // namespace perilymph::haptics
