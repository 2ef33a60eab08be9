// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Landmarks of a cochlea in the markups files of 3D Slicer.

#include <filesystem>
#include <string>

#include "perilymph/ct/Marks.h"
#include "perilymph/foundation/Result.h"

namespace perilymph::imaging {

/// Reads a markups file (.mrk.json) in LPS or RAS; points have the names of ct::nameOf(Mark),
/// others are ignored. Returns an error for a file without a point at the cochlea (RW,
/// C, A), and for points that this program placed in another series.
///
/// @param seriesKey  SHA-256 of the series in which they are used; empty where none is known.
Result<ct::Marks> readLandmarks(const std::filesystem::path& file, const std::string& seriesKey);

}  // namespace perilymph::imaging
