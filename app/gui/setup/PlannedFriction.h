// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The friction that a plan computes with, in words.

#include <QString>

#include "perilymph/planning/Plan.h"

namespace perilymph::gui {

/// The shipped friction of the plans' usual scenario, and the one measured on a tissue simulant.
inline constexpr const char* endosteumFriction = "endosteum";
inline constexpr const char* simulantFriction = "tissue";

/// "friction of endosteum, chosen", "friction of a tissue simulant", "friction soap-50"; of another
/// scenario, "friction of booth".
QString plannedFriction(const planning::PlanRequest& request);

}  // namespace perilymph::gui
