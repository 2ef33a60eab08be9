// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The virtual handle as the device layer finds it.

#include <filesystem>
#include <memory>

#include "perilymph/device/DeviceCodec.h"
#include "perilymph/device/DeviceProfile.h"
#include "perilymph/device/HidDevice.h"
#include "perilymph/device/HidNodes.h"
#include "perilymph/foundation/Result.h"

namespace perilymph::hidstack {

/// The handle's node on this system with the profile that fits it and a codec made from both.
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
