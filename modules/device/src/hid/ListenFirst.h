#pragma once

// What a device just opened tells of itself before its threads start.

#include "hid/ForceWriter.h"
#include "perilymph/device/HapticDevice.h"

namespace perilymph::device {

/// 0 where nothing could be measured.
struct FirstImpression {
  double period = 0.0;      ///< Between reports [s].
  double writeTime = 0.0;   ///< For one force, all its reports; the median [s].
  double answerTime = 0.0;  ///< From a force to the report that answers it; the median [s].
};

/// Reads for at most 0.1 s and sends zero forces meanwhile. A device that reports once for each of
/// our reports, or when it is asked, answers: that is timed.
///
/// @param writing  Null for a device that is never written.
FirstImpression listenFirst(Transport& reading, Transport* writing, const DeviceTraits& profile,
                            ForceWriter& writer, Clock clock);

}  // namespace perilymph::device
