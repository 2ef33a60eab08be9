#pragma once

// Two ways to drive the haptic loop against a HID device.

#include <string>
#include <vector>

#include "TickLog.h"
#include "perilymph/device/HapticDevice.h"
#include "perilymph/foundation/Result.h"

namespace perilymph::hidstack {

/// One tick for every report, in this thread, until the device is gone.
///
/// @param hand  Open.
/// @param node  Of the same device, to wait for its reports.
Result<std::vector<LoopTick>> insertAtDevicesBeat(device::HapticDevice& hand,
                                                  const std::string& node);

/// On the loop's own thread, by the clock, until the device was unplugged so many times. After an
/// unplug the insertion starts anew as soon as the device is back.
Result<std::vector<LoopTick>> insertByTheClock(device::HapticDevice& hand, int unplugs);

}  // namespace perilymph::hidstack
