// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Measurements of a device just opened, before its threads start.

#include "hid/ForceWriter.h"
#include "perilymph/device/HapticDevice.h"

namespace perilymph::device {

/// Measured values; 0 if a value could not be measured.
struct OpeningMeasurement {
  double period = 0.0;      ///< Between reports [s].
  double writeTime = 0.0;   ///< Duration of sending one force, all its reports; the median [s].
  double answerTime = 0.0;  ///< From a force to the report that answers it; the median [s].
};

/// Reads for at most 0.1 s and sends zero forces meanwhile. If the device sends one report for each
/// output report or on request, the time to the answer is measured.
///
/// @param writing  Null for a device that is never written.
OpeningMeasurement measureOnOpening(Transport& reading, Transport* writing,
                                    const DeviceTraits& profile, ForceWriter& writer, Clock clock);

}  // namespace perilymph::device
