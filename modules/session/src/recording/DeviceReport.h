#pragma once

// How a device and the loop did during an insertion, to be kept with it.

#include <string>

#include "perilymph/device/DeviceHealth.h"
#include "perilymph/haptics/HapticLoop.h"

namespace perilymph::session {

/// As JSON: rate and jitter of the reports, what was lost, the time a force takes, the delay there
/// and back, the loop's late ticks and overruns. Keys wear their units.
std::string deviceReport(const device::DeviceHealth& health,
                         const haptics::LoopStatistics& statistics);

}  // namespace perilymph::session
