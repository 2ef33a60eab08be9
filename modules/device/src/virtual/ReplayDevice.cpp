// SPDX-License-Identifier: BSD-3-Clause
#include "virtual/ReplayDevice.h"

#include <utility>

#include "virtual/TimeStep.h"

namespace perilymph::device {

ReplayDevice::ReplayDevice(std::vector<DeviceSample> samples, double timeStep)
    : samples_(std::move(samples)), timeStep_(checkedTimeStep(timeStep))
{
}

DeviceTraits ReplayDevice::traits() const
{
  DeviceTraits traits;
  traits.name = Sentence{"Recorded hand"};
  traits.nominalPeriod = timeStep_;
  return traits;
}

Result<void> ReplayDevice::open()
{
  if (samples_.empty())
    return Error{
        "The recorded hand has no samples; play a recording that holds at least one tick."};
  next_ = 0;
  return {};
}

DeviceSample ReplayDevice::read() noexcept
{
  if (samples_.empty()) return {};
  if (isOver()) return samples_.back();
  return samples_[next_++];
}

void ReplayDevice::write(const Wrench&) noexcept {}

}  // namespace perilymph::device
