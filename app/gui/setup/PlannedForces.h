// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// What plans expect of an insertion.

#include <optional>
#include <string>

#include "gui/run/PlannedForce.h"
#include "perilymph/planning/PlanResult.h"
#include "perilymph/session/Scenario.h"

namespace perilymph::gui {

/// What a plan expects of one of its arrays.
///
/// @param madeUtc  When the plan was made, in ISO 8601.
PlannedForce plannedForce(const planning::Plan& plan, std::size_t array,
                          const std::string& madeUtc);

/// What the newest of the plans on the disk expects that have numbers of a scenario's array in its
/// cochlea; empty if there is none. Any thread.
std::optional<PlannedForce> newestPlannedForce(const session::Scenario& scenario);

}  // namespace perilymph::gui
