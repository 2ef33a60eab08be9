// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The friction that a plan computes with, in words.

#include <QString>

#include "perilymph/planning/Plan.h"

namespace perilymph::gui {

/// The shipped friction that was chosen for the depths in patients.
inline constexpr const char* lowFriction = "low";

/// "friction of a tissue simulant", "low friction, chosen", "friction soap-50"; of another scenario,
/// "friction of booth".
QString plannedFriction(const planning::PlanRequest& request);

}  // namespace perilymph::gui
