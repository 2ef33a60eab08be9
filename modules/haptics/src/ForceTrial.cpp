// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/haptics/ForceTrial.h"

#include <algorithm>
#include <cmath>

namespace perilymph::haptics {

namespace {

SafetyLimits limitsOfTrial(const device::DeviceTraits& traits, double greatest) noexcept
{
  SafetyLimits limits = limitsFor({}, traits);
  limits.maxForce = greatest;
  limits.maxSlew = 10.0;
  // The force profile itself rises slowly from zero.
  limits.rampTime = 0.1;
  return limits;
}

double greatestFor(const device::DeviceTraits& traits) noexcept
{
  const double fraction = traits.maxForce > 0.0 ? 0.2 * traits.maxForce : ForceTrial::maxForce;
  return std::min(ForceTrial::maxForce, fraction);
}

}  // namespace

ForceTrial::ForceTrial(const device::DeviceTraits& traits, double timeStep)
    : timeStep_(timeStep),
      greatest_(greatestFor(traits)),
      axes_(traits.rendersForce ? std::clamp(traits.actuatedTranslations, 0, 3) : 0),
      validator_(timeStep, traits.nominalPeriod),
      safety_(limitsOfTrial(traits, greatest_), timeStep)
{
}

void ForceTrial::note(const HandState& hand, double wanted, double shown,
                      std::uint32_t limits) noexcept
{
  Axis& result = results_[static_cast<std::size_t>(axis_)];
  const double place = hand.position_D[axis_];
  if (time_ == 0.0) {  // also after an interruption
    begin_ = place;
    result = {};
  }
  result.peak = std::max(result.peak, shown);
  result.moved = std::max(result.moved, std::fabs(place - begin_));
  // Only around the middle, where the peak is determined.
  if (wanted > 0.5 * greatest_ && shown < 0.98 * wanted) result.limits |= limits;
}

device::Wrench ForceTrial::step(const device::DeviceSample& sample) noexcept
{
  const HandState& hand = validator_.take(sample);
  isHeld_ = hand.isHeld && !hand.isStale;
  if (isOver()) isHeld_ = false;

  // 0 at both ends of the second, 1 in its middle, smooth
  const double fraction = time_ / timeForAxis;
  const double hump = 16.0 * fraction * fraction * (1.0 - fraction) * (1.0 - fraction);
  Eigen::Vector3d wanted_D = Eigen::Vector3d::Zero();
  if (isHeld_) wanted_D[axis_] = greatest_ * hump;

  HandCondition condition;
  condition.moved_D = hand.moved_D;
  condition.distance = hand.position_D.norm();
  condition.isHeld = isHeld_;
  condition.isStale = hand.isStale;
  condition.hasFault = hand.isLost;
  condition.hasJumped = hand.hasJumped;
  std::uint32_t limits = 0;
  const Eigen::Vector3d shown_D = safety_.show(wanted_D, condition, limits);
  if (isHeld_) note(hand, wanted_D[axis_], shown_D[axis_], limits);

  time_ = isHeld_ ? time_ + timeStep_ : 0.0;
  if (!isOver()) spent_ += timeStep_;
  if (time_ >= timeForAxis) {
    time_ = 0.0;
    spent_ = 0.0;
    results_[static_cast<std::size_t>(axis_)].isDone = true;
    ++axis_;
  }
  device::Wrench wrench_D;
  for (int i = 0; i < 3; ++i) wrench_D.force_D[static_cast<std::size_t>(i)] = shown_D[i];
  return wrench_D;
}

}  // namespace perilymph::haptics
