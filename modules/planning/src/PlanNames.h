// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Names in a plan.json that its writer and its reader share.

#include <array>

#include "perilymph/foundation/Choice.h"

namespace perilymph::planning {

/// Where the errors of the measures come from.
enum class ErrorSource { measured, assumed };
inline constexpr std::array errorSources{
    Choice<ErrorSource>{ErrorSource::measured, "as measured"},
    Choice<ErrorSource>{ErrorSource::assumed, "assumed: 0.1 mm, about a voxel"}};

/// How sure a source is.
inline constexpr std::array confidences{Choice<int>{0, "high"}, Choice<int>{1, "medium"},
                                        Choice<int>{2, "low"}};

}  // namespace perilymph::planning
