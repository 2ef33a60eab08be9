// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// What a plan's bands are called, in one place for its files, figures, report and the window.

#include <string>

#include "perilymph/planning/PlanResult.h"

namespace perilymph::planning {

/// What part of the insertions to come the bands of a plan hold: "90 %"; of fewer than fewestForBand what
/// the bounds are, "5 to 95 % of 32 simulations", "lowest to highest of 16 simulations".
Sentence bandsShare(const Plan& plan);

/// What the bands of a plan hold and what they hold fixed: "90 % over friction 0.08 to 0.33" where
/// the friction's spread is drawn (95 % of it), "90 % at friction 0.12", or "90 % at
/// friction 0.24 to 0.59" where it depends on the speed; "90 % at one friction" for a plan.json that
/// does not state it; of fewer than fewestForBand, "lowest to highest of 16 simulations over friction 0.08 to 0.33".
Sentence bandsHold(const Plan& plan);

}  // namespace perilymph::planning
