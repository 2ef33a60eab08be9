// SPDX-License-Identifier: BSD-3-Clause
#include "PushedDevice.h"

#include <cmath>

#include "perilymph/realtime/Pacer.h"

namespace perilymph::test {

namespace {

constexpr double period = 1e-3;        // [s]
constexpr double step = 20e-3 * 1e-3;  // 20 mm/s [m per period]
constexpr double depth = 24e-3;        // [m]

}  // namespace

void ForceLog::add(double magnitude) noexcept
{
  const std::size_t i = count_;
  if (i == capacity) return;
  entries_[i] = {realtime::monotonicNanoseconds(), magnitude};
  count_ = i + 1;
}

void ForceLog::holdUp(bool isOn)
{
  holdsUp = isOn;
  holdsUp.notify_all();
}

std::size_t ForceLog::firstAfter(std::int64_t time) const
{
  const std::size_t all = size();
  for (std::size_t i = 0; i < all; ++i)
    if (entries_[i].time >= time) return i;
  return all;
}

device::DeviceTraits PushedDevice::traits() const
{
  device::DeviceTraits traits;
  traits.name = "Pushed device";
  traits.rendersForce = true;
  traits.maxForce = maxForce;
  traits.nominalPeriod = period;
  return traits;
}

device::DeviceSample PushedDevice::read() noexcept
{
  // Asleep: a thread of real-time priority that spun would take the processor from the window.
  log_->isHeldUp = log_->holdsUp.load();
  log_->holdsUp.wait(true);
  log_->isHeldUp = false;
  ++sample_.sequence;
  sample_.isValid = 1;
  sample_.buttons = device::graspButton;
  if (log_->isPushed && sample_.position_D[2] > -depth) sample_.position_D[2] -= step;
  log_->isAtDepth = sample_.position_D[2] <= -depth;
  return sample_;
}

void PushedDevice::write(const device::Wrench& wrench_D) noexcept
{
  const auto& force = wrench_D.force_D;
  log_->add(std::hypot(force[0], force[1], force[2]));
}

}  // namespace perilymph::test
