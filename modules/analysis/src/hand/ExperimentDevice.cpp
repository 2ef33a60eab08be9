// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/analysis/ExperimentDevice.h"

#include "perilymph/foundation/Math.h"

namespace perilymph::analysis {

ExperimentDevice::ExperimentDevice(const TremblingPush& push, Duration timeStep)
    : push_(push), timeStep_(timeStep.si())
{
  sample_.isValid = 1;
}

device::DeviceTraits ExperimentDevice::traits() const
{
  device::DeviceTraits traits;
  traits.name = "Materials tester";
  traits.nominalPeriod = timeStep_;
  return traits;
}

device::DeviceSample ExperimentDevice::read() noexcept
{
  // At rest in the report in which it grasps; the base is anchored there.
  if (sample_.buttons != 0) {
    steps_ += 1.0;
    const double time = steps_ * timeStep_;
    sample_.position_D = {0.0, 0.0, -push_.speed * (std::min(steps_, lastStep_) * timeStep_)};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double turn = 2.0 * pi * push_.tremorFrequency * time + push_.tremorPhase[axis];
      sample_.position_D[axis] +=
          push_.tremorAmplitude *
          (sineCosine(turn).sine - sineCosine(push_.tremorPhase[axis]).sine);
    }
  }
  sample_.buttons = device::graspButton;
  ++sample_.sequence;
  return sample_;
}

}  // namespace perilymph::analysis
