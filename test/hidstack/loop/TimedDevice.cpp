// SPDX-License-Identifier: BSD-3-Clause
#include "TimedDevice.h"

#include "perilymph/realtime/Pacer.h"

namespace perilymph::hidstack {

TimedDevice::TimedDevice(device::HapticDevice& hand, std::size_t capacity)
    : hand_(hand), ticks_(capacity)
{
  // Touch every page in advance: recording a tick then causes no page fault.
  ticks_.clear();
}

device::DeviceSample TimedDevice::read() noexcept
{
  const device::DeviceSample sample = hand_.read();
  tick_ = {};
  tick_.sequence = static_cast<std::int64_t>(sample.sequence);
  tick_.isValid = sample.isValid;
  tick_.read = realtime::monotonicNanoseconds();
  return sample;
}

void TimedDevice::write(const device::Wrench& wrench_D) noexcept
{
  tick_.written = realtime::monotonicNanoseconds();
  tick_.force = wrench_D.force_D[2];
  hand_.write(wrench_D);
  if (ticks_.size() < ticks_.capacity()) ticks_.push_back(tick_);
}

}  // namespace perilymph::hidstack
