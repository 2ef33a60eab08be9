#pragma once

// How often a device reports, in words.

#include <QString>
#include <optional>

#include "perilymph/device/DeviceHealth.h"

namespace perilymph::gui {

/// "0.06 ms there and back"; where no report answers a force, the most it can be.
QString roundTripText(const device::DeviceHealth& health);

/// "1000/s, 0.05 ms jitter, 0.06 ms there and back": the status bar's words; empty without a
/// device.
QString deviceRateText(const std::optional<device::DeviceHealth>& health);

}  // namespace perilymph::gui
