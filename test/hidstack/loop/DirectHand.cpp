#include "DirectHand.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cmath>
#include <cstring>

namespace perilymph::hidstack {

device::DeviceTraits DirectHand::traits() const
{
  device::DeviceTraits traits;
  traits.name = node_;
  traits.rendersForce = true;
  traits.mostForce = mostForce;
  traits.nominalPeriod = 1e-3;
  return traits;
}

Result<Done> DirectHand::open()
{
  close();
  file_ = ::open(node_.c_str(), O_RDWR | O_NONBLOCK | O_CLOEXEC);
  if (file_ < 0) return Error{node_ + " could not be opened: " + std::strerror(errno) + "."};
  sample_ = {};
  sample_.isValid = 1;
  return Done{};
}

void DirectHand::close() noexcept
{
  if (file_ >= 0) ::close(file_);
  file_ = -1;
}

std::optional<InputReport> DirectHand::take() noexcept
{
  std::array<std::uint8_t, 64> bytes{};
  const auto size = ::read(file_, bytes.data(), bytes.size());
  if (size <= 0) {
    if (size == 0 || errno != EAGAIN) sample_.isValid = 0;
    return std::nullopt;
  }
  return decodeInput({bytes.data(), static_cast<std::size_t>(size)});
}

device::DeviceSample DirectHand::read() noexcept
{
  while (const auto report = take()) {
    ++sample_.sequence;
    for (std::size_t axis = 0; axis < 3; ++axis)
      sample_.position_D[axis] = placeQuantum * report->place[axis];
    sample_.buttons = report->buttons;
  }
  return sample_;
}

void DirectHand::write(const device::Wrench& wrench_D) noexcept
{
  OutputReport report;
  for (std::size_t axis = 0; axis < 3; ++axis)
    report.force[axis] =
        static_cast<std::int16_t>(std::lround(wrench_D.force_D[axis] / forceQuantum));
  const auto bytes = encode(report);
  [[maybe_unused]] const auto written = ::write(file_, bytes.data(), bytes.size());
}

}  // namespace perilymph::hidstack
