// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The force bands of several arrays in one figure.

#include <vector>

#include "perilymph/figures/Figure.h"
#include "perilymph/planning/Plan.h"

namespace perilymph::gui {

/// Medians and 5 to 95 % over the depth, told apart by color and dashes; at most four arrays.
figures::Figure forceBands(const std::vector<const planning::ArrayPlan*>& arrays);

}  // namespace perilymph::gui
