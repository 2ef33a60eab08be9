// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// A picture of a measured cochlea as a secondary capture in the CT's study.

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "perilymph/foundation/Result.h"

namespace perilymph::archive {

struct SecondaryCapture {
  int width = 0, height = 0;      ///< Pixels.
  std::vector<std::uint8_t> rgb;  ///< Three bytes a pixel, row by row from the top.
  double pixel_mm = 0.0;          ///< Edge of a pixel in the patient.
  bool isRight = false;           ///< The ear.
  std::string description;        ///< What it shows, ASCII, at most 1024 letters.
  std::string software;           ///< Version of the program; at most 64 ASCII letters.
  std::string seriesKey;          ///< SHA-256 of the series that it shows (CtSeries::key).
};

/// Writes a picture as a Secondary Capture Image with new series and instance UIDs, for its owner
/// only, atomically. It names patient and study as the CT does and refers to the CT's images; no
/// letters in the picture name anyone.
///
/// @param ct  The folder of the CT.
/// @return    Refuses a picture whose bytes do not match its size, and a folder without that series.
Result<void> writeSecondaryCapture(const SecondaryCapture& image, const std::filesystem::path& ct,
                                   const std::filesystem::path& file);

}  // namespace perilymph::archive
