// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/device/ScriptedDevice.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "virtual/TimeStep.h"

namespace perilymph::device {

namespace {

/// Faster than any insertion; limits the effect of a mistyped speed [m/s].
constexpr double maxScriptedSpeed = 1.0;

}  // namespace

ScriptedDevice::ScriptedDevice(double speed, double timeStep)
    : speed_(speed), timeStep_(checkedTimeStep(timeStep))
{
  if (!(speed >= 0.0 && speed <= maxScriptedSpeed))  // also catches NaN
    throw std::invalid_argument("The speed of a scripted hand is " + std::to_string(speed * 1e3) +
                                " mm/s; it must be between 0 and 1000 mm/s.");
  sample_.isValid = 1;
}

DeviceTraits ScriptedDevice::traits() const
{
  DeviceTraits traits;
  traits.name = Sentence{"Scripted insertion"};
  traits.nominalPeriod = timeStep_;
  return traits;
}

Result<void> ScriptedDevice::open() { return {}; }

void ScriptedDevice::close() noexcept { motion_ = Motion::hold; }

DeviceSample ScriptedDevice::read() noexcept
{
  const Motion motion = motion_;
  const double asked = speed_;
  const double speed = std::isfinite(asked) ? std::clamp(asked, 0.0, maxScriptedSpeed) : 0.0;

  // A hand that grasps is at rest in that report and moves from the next one on.
  const bool hasHold = (sample_.buttons & graspButton) != 0;
  if (motion != Motion::hold && hasHold) {
    const double step = speed * timeStep_;
    sample_.position_D[2] += motion == Motion::insert ? -step : step;
  }
  sample_.buttons = motion == Motion::hold ? 0u : graspButton;
  ++sample_.sequence;
  return sample_;
}

void ScriptedDevice::write(const Wrench&) noexcept {}

}  // namespace perilymph::device
