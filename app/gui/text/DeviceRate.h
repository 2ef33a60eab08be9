// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Report rate of a device as text.

#include <QString>
#include <optional>

#include "perilymph/device/DeviceHealth.h"

namespace perilymph::gui {

/// "0.06 ms there and back"; an upper bound if no report answers a force.
QString roundTripText(const device::DeviceHealth& health);

/// "1000/s, 0.05 ms jitter, 0.06 ms there and back": text of the status bar; empty without a
/// device.
QString deviceRateText(const std::optional<device::DeviceHealth>& health);

}  // namespace perilymph::gui
