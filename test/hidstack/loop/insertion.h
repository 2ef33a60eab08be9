#pragma once

// An insertion against a HID device, as the workstation runs one.

#include <vector>

#include "TickLog.h"
#include "perilymph/device/HapticDevice.h"
#include "perilymph/foundation/Result.h"

namespace perilymph::hidstack {

/// Runs the haptic loop on its own thread until the device was unplugged so many times. After an
/// unplug the insertion starts anew as soon as the device is back.
///
/// @param hand  Open.
Result<std::vector<LoopTick>> insertUntilUnplugged(device::HapticDevice& hand, int unplugs);

}  // namespace perilymph::hidstack
