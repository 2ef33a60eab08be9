// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Center frequencies that sound processors give an array's contacts by default.

#include <vector>

#include "perilymph/electrode/ArrayDesign.h"
#include "perilymph/foundation/Result.h"

namespace perilymph::planning {

/// Center frequencies [Hz] of an array's contacts from the tip, as shipped; empty if its maker states none
/// for its number of contacts. An error if the shipped file cannot be read.
Result<std::vector<double>> defaultFiltersOf(const electrode::ArrayDesign& array);

}  // namespace perilymph::planning
