#include "perilymph/device/ReplayHand.h"

#include <utility>

#include "virtual/TimeStep.h"

namespace perilymph::device {

ReplayHand::ReplayHand(std::vector<DeviceSample> samples, double timeStep)
    : samples_(std::move(samples)), timeStep_(checkedTimeStep(timeStep))
{
}

DeviceTraits ReplayHand::traits() const
{
  DeviceTraits traits;
  traits.name = "Recorded hand";
  traits.nominalPeriod = timeStep_;
  return traits;
}

Result<Done> ReplayHand::open()
{
  if (samples_.empty())
    return Error{
        "The recorded hand has no samples; play a recording that holds at least one tick."};
  next_ = 0;
  return Done{};
}

DeviceSample ReplayHand::read() noexcept
{
  if (samples_.empty()) return {};
  if (isOver()) return samples_.back();
  return samples_[next_++];
}

void ReplayHand::write(const Wrench&) noexcept {}

}  // namespace perilymph::device
