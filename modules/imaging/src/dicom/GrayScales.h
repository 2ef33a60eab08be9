// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Whether slopes and intercepts that differ between slices are plausible.

#include <string>
#include <vector>

#include "DicomSeries.h"
#include "Rectification.h"
#include "perilymph/foundation/Result.h"

namespace perilymph::imaging {

/// Compares the gray values of slices whose slope or intercept differs from their neighbor's: where a scanner scales
/// each slice, its own scale joins it to its neighbors better than theirs would. Returns a warning for a series
/// whose scales differ, and nothing for one scale.
///
/// Refuses a slice that its neighbors' scale would fit better, naming its file and values. Where most slices have one
/// scale, another one must fit better; where each has its own, differences that noise hides are only warned of.
Result<std::vector<Sentence>> checkScales(const DicomSeries& series, const Grid& grid);

}  // namespace perilymph::imaging
