// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// An insertion against a HID device, as the workstation runs one.

#include <vector>

#include "TickLog.h"
#include "perilymph/device/HapticDevice.h"
#include "perilymph/foundation/Result.h"

namespace perilymph::hidstack {

/// Runs the haptic loop on its own thread until the device was disconnected a number of times.
/// After a disconnection the insertion restarts as soon as the device is back.
///
/// @param hand  Open.
Result<std::vector<LoopTick>> insertUntilUnplugged(device::HapticDevice& hand, int unplugs);

/// Runs it for a number of ticks, then kills this process while it runs.
Result<void> insertUntilKilled(device::HapticDevice& hand, std::size_t ticks);

}  // namespace perilymph::hidstack
