// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// From a row of a plan to an insertion.

#include "gui/setup/Setup.h"
#include "perilymph/planning/PlanResult.h"

namespace perilymph::gui {

/// The plan's scenario with its patient and one of its arrays, inserted fully.
Result<Setup> plannedSetup(const planning::Plan& plan, std::size_t array);

}  // namespace perilymph::gui
