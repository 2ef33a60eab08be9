// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The force bands of several arrays in one figure.

#include <vector>

#include "perilymph/figures/Figure.h"
#include "perilymph/planning/PlanResult.h"

namespace perilymph::gui {

/// Medians and bands of arrays of a plan over the depth, distinguished by color and dashes; at most four.
figures::Figure forceBands(const planning::Plan& plan, const std::vector<std::size_t>& arrays);

}  // namespace perilymph::gui
