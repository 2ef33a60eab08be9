// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Evaluation of a tape: its reports decoded as samples.

#include <array>
#include <cstdint>

#include "perilymph/device/DeviceCodec.h"
#include "perilymph/device/DeviceHealth.h"
#include "perilymph/device/ReportTape.h"

namespace perilymph::device {

struct TapeReading {
  ReadingFigures reading;  ///< Rate and intervals over the whole tape.
  WritingFigures writing;
  double duration = 0.0;          ///< From the first entry to the last [s].
  std::array<double, 3> min_D{};  ///< Minimum of every coordinate [m].
  std::array<double, 3> max_D{};  ///< [m]
  std::uint32_t buttons = 0;      ///< All buttons that were pressed at any time.
};

/// Decodes every input report with the codec, at the time of its arrival.
///
/// @param period  Between reports [s], from the profile.
TapeReading readTape(const ReportTape& tape, DeviceCodec& codec, double period);

}  // namespace perilymph::device
