// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Messages of the process that hosts a plug-in, which the plug-in may have overwritten.

#include <string>

#include "perilymph/device/HapticDevice.h"
#include "perilymph/foundation/Result.h"
#include "plugin/PluginChannel.h"

namespace perilymph::device::plugin {

/// Why a request failed, as the host states it; may be empty.
std::string sentenceOf(const Reply& reply);

/// Validates the traits of a plug-in; invalid ones could permit any force.
Result<DeviceTraits> checkedTraits(const PerilymphDeviceTraitsV1& said);

}  // namespace perilymph::device::plugin
