// SPDX-License-Identifier: BSD-3-Clause
#include "virtualDevice.h"

#include <poll.h>

#include <span>
#include <utility>

#include "codec/ReportDescriptor.h"
#include "hid/HidPort.h"

namespace perilymph::hidstack {

namespace {

constexpr int glance_ms = 5;

}  // namespace

Result<VirtualDevice> findVirtualDevice(const std::filesystem::path& profileFile, double timeout)
{
  const auto profile = device::loadProfile(profileFile);
  if (!profile) return profile.error();
  for (int waited_ms = 0; waited_ms <= static_cast<int>(1e3 * timeout); waited_ms += glance_ms) {
    for (device::HidNode& node : device::findHidNodes()) {
      if (node.access != device::NodeAccess::allowed) continue;
      auto descriptor = device::ReportDescriptor::parse(node.descriptor);
      if (!descriptor) return descriptor.error();
      const std::span<const device::DeviceProfile> one(&*profile, 1);
      if (device::matchingProfile(one, node.identity, *descriptor) == nullptr) continue;
      auto codec = device::makeCodec(*profile, *descriptor);
      if (!codec) return codec.error();
      return VirtualDevice{std::move(node), device::traitsOf(*profile, *descriptor),
                           std::move(*codec)};
    }
    ::poll(nullptr, 0, glance_ms);
  }
  return Error{"No device that fits " + profileFile.string() + " was plugged in within " +
               std::to_string(timeout) + " s."};
}

Result<std::unique_ptr<device::HidDevice>> openVirtualDevice(const std::filesystem::path& profile,
                                                             double timeout)
{
  auto found = findVirtualDevice(profile, timeout);
  if (!found) return found.error();
  return std::make_unique<device::HidDevice>(std::move(found->traits), std::move(found->codec),
                                             device::hidPort(std::move(found->node)));
}

}  // namespace perilymph::hidstack
