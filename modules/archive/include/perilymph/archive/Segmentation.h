// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The fitted lumen of a cochlea as a DICOM segmentation of the CT's series.

#include <array>
#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "perilymph/foundation/Result.h"

namespace perilymph::archive {

/// A tube from rings of points, each with the same number of points in the same sense; flat fans
/// close its ends. What lies in the tube is the lumen, where turns touch it is counted once.
struct Lumen {
  std::vector<std::array<double, 3>> points_mm;  ///< In the frame of the CT, LPS; ring by ring.
  std::size_t pointsPerRing = 0;
  bool isRight = false;
  bool hasMarksByHand = false;  ///< A person placed landmarks that steered the fit.
  std::string software;         ///< Version of the program; at most 64 ASCII letters.
  std::string seriesKey;        ///< SHA-256 of the series that was measured (CtSeries::key).
};

/// Writes a binary segmentation with new series and instance UIDs, for its owner only, atomically. It
/// has a frame of the CT's own rows and columns for each slice whose voxel centers lie in the lumen,
/// refers to that slice, and names patient, study and frame of reference as the CT does.
///
/// @param ct  The folder of the CT.
/// @return    Refuses a tube of fewer than two rings, a folder without that series, a series of
///            multi-frame files or without a frame of reference, and a lumen outside of all slices.
Result<void> writeSegmentation(const Lumen& lumen, const std::filesystem::path& ct,
                               const std::filesystem::path& file);

}  // namespace perilymph::archive
