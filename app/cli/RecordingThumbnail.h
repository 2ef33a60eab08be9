// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// A recording as a small picture, which file managers show in place of an icon.

#include "perilymph/analysis/ForceProfile.h"
#include "perilymph/figures/Drawing.h"

namespace perilymph::cli {

/// Force over travel with the peak force and the largest insertion depth as numbers; nothing of the patient.
///
/// @param side  Side of the square drawing [1/72 inch].
figures::Drawing thumbnailOf(const analysis::ForceProfile& profile, double side);

}  // namespace perilymph::cli
