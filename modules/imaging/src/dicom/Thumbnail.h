// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// A small picture of a series.

#include <stop_token>

#include "DicomSeries.h"
#include "perilymph/foundation/Result.h"

namespace perilymph::imaging {

/// Decodes the middle slice of a series and reduces it by averaging to at most `edge` pixels; black
/// and white are the 1st and 99th percentile.
Result<CtThumbnail> thumbnailOf(const DicomSeries& series, int edge, const std::stop_token& stop);

}  // namespace perilymph::imaging
