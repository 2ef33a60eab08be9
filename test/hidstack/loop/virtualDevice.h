// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The virtual handle as found by the device layer.

#include <filesystem>
#include <memory>

#include "codec/DeviceCodec.h"
#include "codec/DeviceProfile.h"
#include "hid/HidDevice.h"
#include "perilymph/device/HidNodes.h"
#include "perilymph/foundation/Result.h"

namespace perilymph::hidstack {

/// The handle's node on this system with its profile and codec.
struct VirtualDevice {
  device::HidNode node;
  device::DeviceTraits traits;
  std::unique_ptr<device::DeviceCodec> codec;
};

/// Waits until the handle is connected, at most a given time [s]. The error names what is missing.
Result<VirtualDevice> findVirtualDevice(const std::filesystem::path& profile, double timeout);

/// The same as a HapticDevice, not opened.
Result<std::unique_ptr<device::HidDevice>> openVirtualDevice(const std::filesystem::path& profile,
                                                             double timeout);

}  // namespace perilymph::hidstack
