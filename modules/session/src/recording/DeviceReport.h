// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Report on the performance of device and loop during an insertion, stored with it.

#include <string>

#include "perilymph/device/DeviceHealth.h"
#include "perilymph/haptics/HapticLoop.h"

namespace perilymph::session {

/// The report as JSON: rate and jitter of reports, losses, duration of writing a force, round-trip
/// delay, the loop's late ticks and overruns. Keys end with their units.
std::string deviceReport(const device::DeviceHealth& health,
                         const haptics::LoopStatistics& statistics);

}  // namespace perilymph::session
