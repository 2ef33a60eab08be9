// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/haptics/Safety.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "perilymph/haptics/Snapshot.h"

namespace perilymph::haptics {

namespace {

/// Length of a nonzero vector, without overflow for finite components.
double length(const Eigen::Vector3d& vector) noexcept
{
  const double largest = std::max({std::abs(vector[0]), std::abs(vector[1]), std::abs(vector[2])});
  const Eigen::Vector3d scaled = vector / largest;
  return largest * std::sqrt(scaled[0] * scaled[0] + scaled[1] * scaled[1] + scaled[2] * scaled[2]);
}

/// The vector, shortened to length `maximum` if longer.
Eigen::Vector3d shortened(const Eigen::Vector3d& vector, double maximum) noexcept
{
  const double largest = std::max({std::abs(vector[0]), std::abs(vector[1]), std::abs(vector[2])});
  if (largest == 0.0 || length(vector) <= maximum) return vector;
  const Eigen::Vector3d direction = vector / largest;
  return direction * (maximum / length(direction));
}

bool isFinite(const Eigen::Vector3d& vector) noexcept
{
  return std::isfinite(vector[0]) && std::isfinite(vector[1]) && std::isfinite(vector[2]);
}

double checked(double value, double maximum, const char* name, const char* unit)
{
  if (!(value > 0.0 && value <= maximum))  // also catches NaN
    throw std::invalid_argument(std::string(name) + " is " + std::to_string(value) + " " + unit +
                                "; it must be above 0 and at most " + std::to_string(maximum) +
                                " " + unit + ".");
  return value;
}

}  // namespace

SafetyLimits limitsFor(SafetyLimits limits, const device::DeviceTraits& traits) noexcept
{
  if (traits.rendersForce && traits.maxForce > 0.0)
    limits.maxForce = std::min(limits.maxForce, traits.maxForce);
  if (traits.rendersForce && traits.workspaceRadius > 0.0) limits.reach = traits.workspaceRadius;
  return limits;
}

Safety::Safety(const SafetyLimits& limits, double timeStep)
    : limits_(limits), timeStep_(timeStep), passivity_(timeStep)
{
  // 20 N is the strongest device in use here (Force Dimension delta.3).
  checked(limits.maxForce, 20.0, "The greatest force shown", "N");
  checked(limits.maxSlew, 1e4, "The greatest change of the force shown", "N/s");
  checked(limits.rampTime, 10.0, "The time over which the force fades in", "s");
  if (limits.offTime != 0.0)
    checked(limits.offTime, 10.0, "The time in which the force is switched off", "s");
  if (limits.reach != 0.0) checked(limits.reach, 10.0, "The reach of the device", "m");
  checked(timeStep, 0.1, "The time step of the safety chain", "s");
}

void Safety::lowerMaxForce(double maxForce) noexcept
{
  if (maxForce > 0.0) limits_.maxForce = std::min(limits_.maxForce, maxForce);
}

double Safety::fractionWithinReach(double distance) const noexcept
{
  if (!(limits_.reach > 0.0)) return 1.0;
  // the last tenth of the reach
  return std::clamp(10.0 * (limits_.reach - distance) / limits_.reach, 0.0, 1.0);
}

Eigen::Vector3d Safety::show(const Eigen::Vector3d& wanted_D, const HandCondition& hand,
                             std::uint32_t& status) noexcept
{
  passivity_.observe(shown_D_, hand.moved_D);

  Eigen::Vector3d force_D = Eigen::Vector3d::Zero();
  if (isFinite(wanted_D)) force_D = wanted_D;

  // clamp
  const Eigen::Vector3d clamped_D = shortened(force_D, limits_.maxForce);
  if (clamped_D != force_D) status |= forceClamped;
  force_D = clamped_D;

  // fade in, or shut off
  const bool isOff = !hand.isHeld || hand.isStale || hand.hasFault;
  if (isOff || hand.hasJumped)
    ramp_ = 0.0;
  else
    ramp_ = std::min(1.0, ramp_ + timeStep_ / limits_.rampTime);
  if (!isOff && ramp_ < 1.0) status |= rampingIn;
  force_D *= ramp_;
  if (hand.isStale) status |= staleSample;

  // fade out toward the end of the reach
  const double fraction = fractionWithinReach(hand.distance);
  if (fraction < 1.0) status |= nearWorkspaceEnd;
  force_D *= fraction;

  // passivity: return no more energy than was supplied
  if (!isOff) {
    const Eigen::Vector3d passive_D = passivity_.control(force_D, hand.moved_D);
    if (passive_D != force_D) status |= passivityActed;
    force_D = shortened(passive_D, limits_.maxForce);
  }

  // slew limit
  const Eigen::Vector3d step_D = force_D - shown_D_;
  const double slew = isOff && limits_.offTime > 0.0
                          ? std::max(limits_.maxSlew, limits_.maxForce / limits_.offTime)
                          : limits_.maxSlew;
  const Eigen::Vector3d allowed_D = shortened(step_D, slew * timeStep_);
  if (allowed_D != step_D) {
    status |= forceSlewed;
    force_D = shown_D_ + allowed_D;
  }
  shown_D_ = force_D;
  return shown_D_;
}

void Safety::addTo(Hash& hash) const noexcept
{
  passivity_.addTo(hash);
  hash.add(ramp_);
  hash.add(limits_.maxForce);
  for (int i = 0; i < 3; ++i) hash.add(shown_D_[i]);
}

}  // namespace perilymph::haptics
