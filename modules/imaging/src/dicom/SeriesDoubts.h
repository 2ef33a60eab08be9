// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// What a series states twice, and not alike.

#include <string>
#include <vector>

#include "DicomSeries.h"

namespace perilymph::imaging {

/// Sentences about what the headers of a series that has a stack state otherwise than the positions of its slices, and
/// about images that are missing. Positions and orientations are what the volume is built from.
std::vector<Sentence> doubtsOf(const DicomSeries& series);

}  // namespace perilymph::imaging
