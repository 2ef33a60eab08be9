// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Evaluation of a tape: its reports decoded as samples.

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>

#include "perilymph/device/DeviceHealth.h"
#include "perilymph/device/HidNodes.h"
#include "perilymph/foundation/Result.h"

namespace perilymph::device {

struct TapeReading {
  std::string name;  ///< Name of the device, as it calls itself.
  HidIdentity identity;
  std::string profile;     ///< Name of the profile it was read with.
  std::uint64_t lost = 0;  ///< Reports that the tape had no room for.
  ReadingFigures reading;  ///< Rate and intervals over the whole tape.
  WritingFigures writing;
  double duration = 0.0;          ///< From the first entry to the last [s].
  std::array<double, 3> min_D{};  ///< Minimum of every coordinate [m].
  std::array<double, 3> max_D{};  ///< [m]
  std::uint32_t buttons = 0;      ///< All buttons that were pressed at any time.
};

/// Decodes every input report of a tape, at the time of its arrival, with the best matching shipped
/// profile.
Result<TapeReading> readTape(const std::filesystem::path& file);

}  // namespace perilymph::device
