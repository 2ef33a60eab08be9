// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/analysis/InsertionByHand.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <stop_token>

#include "ProfilePoints.h"
#include "perilymph/analysis/ContactPositions.h"
#include "perilymph/analysis/ExperimentDevice.h"
#include "perilymph/analysis/ForceProfile.h"
#include "perilymph/analysis/RunningMean.h"
#include "perilymph/analysis/StopCurve.h"
#include "perilymph/analysis/StopForce.h"
#include "perilymph/session/Highlights.h"
#include "perilymph/session/Insertion.h"

namespace perilymph::analysis {

using haptics::InsertionEnd;

namespace {

/// Depth from which a tip counts as inside; above the amplitude of the tremor (choice, high).
constexpr Length entered = millimeters(0.2);
/// Travel beyond the full depth that the engine allows: the hand stops, and its tremor goes on.
constexpr Length beyond = millimeters(1);

/// The parameters with the surgeon's speed, grip and friction of the lining.
session::InsertionParameters withSurgeon(const session::InsertionParameters& nominal,
                                         const Surgeon& surgeon)
{
  session::InsertionParameters parameters = nominal;
  parameters.withdraws = false;
  parameters.speed = surgeon.speed;
  parameters.freeLength = surgeon.freeLength;
  parameters.stopTravel = nominal.stopTravel + beyond;
  parameters.engine.stopTravel = parameters.stopTravel.si();
  parameters.engine.samplePeriod = nominal.timeStep.si();
  parameters.friction = nominal.friction.scaled(surgeon.frictionFactor);
  // a point set cannot go through the partition
  if (nominal.model == mechanics::ModelKind::rod) parameters.partitionStrength = surgeon.rupture;
  return parameters;
}

TremblingPush pushOf(const HandDistribution& hand, const Surgeon& surgeon)
{
  // a sine of amplitude a along each of three axes has the root mean square a sqrt(3 / 2)
  return {.speed = surgeon.speed.si(),
          .tremorAmplitude = surgeon.tremor.si() / std::sqrt(1.5),
          .tremorFrequency = hand.tremorFrequency,
          .tremorPhase = surgeon.tremorPhase};
}

/// Ticks of a push at most: twice the time for the travel, plus a second to start.
std::uint64_t maxTicks(const session::InsertionParameters& parameters, const Surgeon& surgeon)
{
  return static_cast<std::uint64_t>((2.0 * parameters.stopTravel.si() / surgeon.speed.si() + 1.0) /
                                    parameters.timeStep.si());
}

/// The longer rest after which the force is read.
constexpr Duration longRest = seconds(10);

/// Recognizes the end of the push.
class Watch {
public:
  Watch(const session::InsertionParameters& nominal, const HandDistribution& hand,
        const Surgeon& surgeon, const Eigen::Vector3d& out_W)
      : out_W_(out_W),
        intendedDepth_(intendedDepth(nominal, surgeon).si()),
        startDepth_(nominal.startInside.si()),
        stop_(surgeon.stop.si()),
        lag_(hand.bucklingLag.si())
  {
  }

  /// The end that this tick shows, if any.
  std::optional<InsertionEnd> take(const haptics::TickOutput& now)
  {
    const Eigen::Vector3d base_W(now.proxy_W[0], now.proxy_W[1], now.proxy_W[2]);
    if (!start_W_) start_W_ = base_W;
    const double pushed = (*start_W_ - base_W).dot(out_W_);
    hasEntered_ = hasEntered_ || now.depth > startDepth_ + entered.si();
    if (now.depth >= intendedDepth_) return InsertionEnd::finished;
    if (hasEntered_ && now.depth <= 0.0) return InsertionEnd::outOfOpening;
    if (pushed - (now.depth - startDepth_) > lag_) return InsertionEnd::buckled;
    // the force of a tick that is not balanced is none of the array
    const bool isBalanced = (now.status & haptics::notConverged) == 0;
    if (isBalanced && now.axialForce >= stop_) return InsertionEnd::stoppedByResistance;
    return std::nullopt;
  }

private:
  Eigen::Vector3d out_W_;
  double intendedDepth_, startDepth_;       // [m]
  double stop_;                             // [N]
  double lag_;                              // [m]
  std::optional<Eigen::Vector3d> start_W_;  // of the tweezers
  bool hasEntered_ = false;
};

}  // namespace

Length intendedDepth(const session::InsertionParameters& nominal, const Surgeon& surgeon)
{
  const Length greatest = nominal.startInside + nominal.stopTravel;
  const auto& contacts = nominal.array.contactsFromTip;
  if (contacts.empty()) return greatest;
  const Length allInside = std::min(greatest, contacts.back() + 0.5 * nominal.array.contactLength);
  return allInside + surgeon.intended * (greatest - allInside);
}

ClinicalInsertion insertByHand(const session::InsertionParameters& nominal,
                               std::shared_ptr<const anatomy::ScalaTympani> anatomy,
                               const HandDistribution& hand, const Surgeon& surgeon,
                               Length profileSpacing, const std::stop_token& stop,
                               haptics::Snapshot* shape)
{
  ClinicalInsertion result;
  result.sharedFriction = surgeon.sharedFriction;
  const session::InsertionParameters parameters = withSurgeon(nominal, surgeon);
  const auto forceps =
      std::make_shared<ExperimentDevice>(pushOf(hand, surgeon), parameters.timeStep);
  auto insertion = session::Insertion::prepare(parameters, forceps, anatomy);
  if (!insertion) {
    result.reason = insertion.error().message;
    return result;
  }

  Watch watch(nominal, hand, surgeon, anatomy->entry().out_W);
  std::optional<InsertionEnd> end;
  haptics::TickOutput last;
  const auto note = [&](const haptics::TickOutput& now) {
    last = now;
    if (haptics::raisesPeak(now, result.peak.si())) result.peak = newtons(now.axialForce);
    result.partition = newtons(std::max(result.partition.si(), now.partitionForce));
  };
  ProfilePoints points(profileSpacing);
  const double step = nominal.timeStep.si();
  const auto ticksIn = [step](Duration time) {
    return static_cast<std::size_t>(std::lround(time.si() / step));
  };
  StopForce force(hand.restMean);
  const auto push = [&](const haptics::TickRecord& record) {
    note(record.output);
    force.add(record.output);
    points.add(result.profile, record.output.depth, record.output.axialForce);
    if (record.output.workflow == haptics::Workflow::inserting) end = watch.take(record.output);
    if (record.output.workflow == haptics::Workflow::finished) end = endOf(record.output);
    return !end && !stop.stop_requested();
  };
  auto ran = (*insertion)->runToEnd(push, maxTicks(parameters, surgeon));
  if (stop.stop_requested()) return result;

  result.endForce = newtons(force.value());
  if (ran) {
    forceps->rest();
    RunningMean atRest(hand.restMean);
    std::size_t tick = 0;
    const auto rest = [&](const haptics::TickRecord& record) {
      note(record.output);
      atRest.add(record.output.time, record.output.axialForce);
      ++tick;
      if (tick == ticksIn(shortRest())) result.forceAfter1s = newtons(atRest.mean());
      if (tick == ticksIn(longRest)) result.forceAfter10s = newtons(atRest.mean());
      return !stop.stop_requested();
    };
    ran = (*insertion)->runToEnd(rest, ticksIn(hand.rest));
  }
  if (stop.stop_requested()) return result;
  result.end = ran ? end.value_or(InsertionEnd::fault) : InsertionEnd::fault;
  if (!ran) result.reason = ran.error().message;
  result.depth = meters(last.depth);
  result.isRuptured = (last.status & haptics::partitionRuptured) != 0;
  result.isTranslocated = (last.status & haptics::translocated) != 0;
  result.ruptureAngle = radians(last.translocation.angle);
  (*insertion)->refresh();
  if (shape != nullptr) *shape = (*insertion)->latest();
  result.contacts = contactPositions(*anatomy, nominal.array, (*insertion)->latest());
  result.apical = angularInsertionDepth(result.contacts);
  return result;
}

std::optional<Length> StopCurve::lengthAt(Force limit) const
{
  const auto found = std::find_if(rises.begin(), rises.end(),
                                  [limit](const DepthForce& rise) { return rise.force >= limit; });
  if (found == rises.end()) return std::nullopt;
  return found->depth;
}

StopCurve pushWithoutStop(const session::InsertionParameters& nominal,
                          std::shared_ptr<const anatomy::ScalaTympani> anatomy,
                          const HandDistribution& hand, const Surgeon& surgeon,
                          const std::stop_token& stop)
{
  Surgeon unlimited = surgeon;
  unlimited.stop = highestStop;
  unlimited.intended = 1.0;
  StopCurve curve;
  const session::InsertionParameters parameters = withSurgeon(nominal, unlimited);
  const auto forceps =
      std::make_shared<ExperimentDevice>(pushOf(hand, unlimited), parameters.timeStep);
  auto insertion = session::Insertion::prepare(parameters, forceps, anatomy);
  if (!insertion) return curve;
  Watch watch(nominal, hand, unlimited, anatomy->entry().out_W);
  std::optional<InsertionEnd> end;
  Force above = newtons(0.0);  // from here on a rise is a point
  const auto push = [&](const haptics::TickRecord& record) {
    const haptics::TickOutput& now = record.output;
    curve.depth = meters(now.depth);
    if (now.workflow == haptics::Workflow::inserting) {
      const bool isBalanced = (now.status & haptics::notConverged) == 0;
      if (isBalanced && now.axialForce >= above.si()) {
        curve.rises.push_back({meters(now.depth), newtons(now.axialForce)});
        above = newtons(now.axialForce) + stopResolution;
      }
      end = watch.take(now);
    }
    if (now.workflow == haptics::Workflow::finished) end = endOf(now);
    return !end && !stop.stop_requested();
  };
  const auto ran = (*insertion)->runToEnd(push, maxTicks(parameters, surgeon));
  curve.end = ran ? end.value_or(InsertionEnd::fault) : InsertionEnd::fault;
  return curve;
}

}  // namespace perilymph::analysis
