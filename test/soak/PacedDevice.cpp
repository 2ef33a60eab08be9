// SPDX-License-Identifier: BSD-3-Clause
#include "PacedDevice.h"

namespace perilymph::test {

device::DeviceTraits PacedDevice::traits() const
{
  device::DeviceTraits traits;
  traits.name = "Paced hand";
  return traits;
}

device::DeviceSample PacedDevice::read() noexcept
{
  const bool holds = direction_ == Direction::in || direction_ == Direction::out;
  // A hand that takes hold is at rest in that report and moves from the next one on.
  if (direction_ == Direction::in && hadHold_) ++place_;
  if (direction_ == Direction::out && hadHold_) --place_;
  if (direction_ == Direction::home && place_ != 0) place_ += place_ > 0 ? -1 : 1;
  hadHold_ = holds;

  device::DeviceSample sample;
  sample.sequence = ++sequence_;
  sample.position_D[2] = -step_ * static_cast<double>(place_);
  sample.buttons = holds ? device::graspButton : 0u;
  sample.isValid = 1;
  return sample;
}

}  // namespace perilymph::test
