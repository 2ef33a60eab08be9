// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Evaluation of a tape with a given codec.

#include "codec/DeviceCodec.h"
#include "perilymph/device/TapeReading.h"
#include "tape/ReportTape.h"

namespace perilymph::device {

/// Decodes every input report with the codec, at the time of its arrival.
///
/// @param period  Between reports [s], from the profile.
TapeReading readTape(const ReportTape& tape, DeviceCodec& codec, double period);

}  // namespace perilymph::device
