// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/haptics/ForceTrial.h"

#include <algorithm>
#include <cmath>

namespace perilymph::haptics {

namespace {

/// At most a fifth of what the device can.
double greatestFor(double ofDevice, double ofTrial) noexcept
{
  return ofDevice > 0.0 ? std::min(ofTrial, 0.2 * ofDevice) : ofTrial;
}

/// A hand that holds the handle loosely moves it by less on its own in a second (choices).
constexpr double clearlyMoved = 0.5e-3;  // [m]
constexpr double clearlyTurned = 0.02;   // [rad]

/// After an interrupted push the handle swings back, before the axis is pushed again (a choice) [s].
constexpr double restTime = 0.3;

/// Limits for a push of this strength [N] or [N.m].
SafetyLimits limitsOfTrial(const device::DeviceTraits& traits, double greatest) noexcept
{
  SafetyLimits limits = limitsFor({}, traits);
  limits.maxForce = greatest;
  limits.maxSlew = 20.0 * greatest;  // the push itself rises by at most 3.1 of it per second
  // The force profile itself rises slowly from zero.
  limits.rampTime = 0.1;
  return limits;
}

/// Rotation about an axis of D between two orientations [rad], for the small ones of a push: twice the
/// sine of half the angle, 0.4 % less than the angle at 0.3 rad.
double turnAbout(int axis, const Eigen::Quaterniond& from_D,
                 const Eigen::Quaterniond& to_D) noexcept
{
  const Eigen::Quaterniond turn = to_D * from_D.conjugate();
  return turn.w() < 0.0 ? -2.0 * turn.vec()[axis] : 2.0 * turn.vec()[axis];
}

}  // namespace

ForceTrial::ForceTrial(const device::DeviceTraits& traits, double timeStep)
    : timeStep_(timeStep),
      greatest_(greatestFor(traits.maxForce, maxForce)),
      greatestTorque_(greatestFor(traits.maxTorque, maxTorque)),
      validator_(timeStep, traits.nominalPeriod),
      safety_(limitsOfTrial(traits, greatest_), timeStep),
      torqueSafety_(limitsOfTrial(traits, greatestTorque_), timeStep)
{
  for (int i = 0; i < 3; ++i) {
    results_[static_cast<std::size_t>(i)].isActuated = traits.pushesAlong(i);
    results_[static_cast<std::size_t>(i + 3)].isActuated = traits.turnsAbout(i);
  }
  skipFixedAxes();
}

void ForceTrial::skipFixedAxes() noexcept
{
  while (axis_ < axes && !results_[static_cast<std::size_t>(axis_)].isActuated) ++axis_;
}

double ForceTrial::placeOf(const HandState& hand) const noexcept
{
  return axis_ < 3 ? hand.position_D[axis_]
                   : turnAbout(axis_ - 3, beginRotation_D_, hand.rotation_D);
}

void ForceTrial::note(const HandState& hand, double wanted, double shown,
                      std::uint32_t limits) noexcept
{
  Axis& result = results_[static_cast<std::size_t>(axis_)];
  if (time_ == 0.0) {  // also after an interruption
    beginRotation_D_ = hand.rotation_D;
    begin_ = placeOf(hand);
    result = {};
    result.isActuated = true;
    pushed_ = 0.0;
  }
  result.peak = std::max(result.peak, shown);
  const double moved = placeOf(hand) - begin_;
  result.moved = std::max(result.moved, std::fabs(moved));
  pushed_ += shown;
  if (pushed_ > 0.0) result.leaned += shown / pushed_ * (moved - result.leaned);
  result.isAgainst = result.leaned < -(axis_ < 3 ? clearlyMoved : clearlyTurned);
  // Only around the middle, where the peak is determined.
  const double greatest = axis_ < 3 ? greatest_ : greatestTorque_;
  if (wanted > 0.5 * greatest && shown < 0.98 * wanted) result.limits |= limits;
}

device::Wrench ForceTrial::step(const device::DeviceSample& sample) noexcept
{
  const HandState& hand = validator_.take(sample);
  isHeld_ = hand.isHeld && !hand.isStale;
  if (isOver()) isHeld_ = false;
  if (!isHeld_ && time_ > 0.0) rest_ = restTime;
  const bool isPushed = isHeld_ && rest_ <= 0.0;
  if (isHeld_) rest_ = std::max(0.0, rest_ - timeStep_);

  // 0 at both ends of the second, 1 in its middle, smooth
  const double fraction = time_ / timeForAxis;
  const double hump = 16.0 * fraction * fraction * (1.0 - fraction) * (1.0 - fraction);
  Eigen::Vector3d force_D = Eigen::Vector3d::Zero(), torque_D = Eigen::Vector3d::Zero();
  if (isPushed && axis_ < 3) force_D[axis_] = greatest_ * hump;
  if (isPushed && axis_ >= 3) torque_D[axis_ - 3] = greatestTorque_ * hump;
  const double wanted = force_D.sum() + torque_D.sum();

  HandCondition condition;
  condition.moved_D = hand.moved_D;
  condition.distance = hand.position_D.norm();
  condition.isHeld = isHeld_;
  condition.isStale = hand.isStale;
  condition.hasFault = hand.isLost;
  condition.hasJumped = hand.hasJumped;
  std::uint32_t limits = 0;
  force_D = safety_.show(force_D, condition, limits);
  // The passivity of a force is about motion along it, not about rotation.
  condition.moved_D.setZero();
  torque_D = torqueSafety_.show(torque_D, condition, limits);
  if (isPushed) note(hand, wanted, axis_ < 3 ? force_D[axis_] : torque_D[axis_ - 3], limits);

  time_ = isPushed ? time_ + timeStep_ : 0.0;
  if (!isOver()) spent_ += timeStep_;
  if (time_ >= timeForAxis) {
    time_ = 0.0;
    spent_ = 0.0;
    results_[static_cast<std::size_t>(axis_)].isDone = true;
    ++axis_;
    skipFixedAxes();
  }
  device::Wrench wrench_D;
  for (std::size_t i = 0; i < 3; ++i) {
    wrench_D.force_D[i] = force_D[static_cast<Eigen::Index>(i)];
    wrench_D.torque_D[i] = torque_D[static_cast<Eigen::Index>(i)];
  }
  return wrench_D;
}

}  // namespace perilymph::haptics
