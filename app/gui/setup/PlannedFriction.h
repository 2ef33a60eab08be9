// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The friction that a plan computes with, what its bands hold and shares of its simulations, in words.

#include <QString>

#include "perilymph/planning/PlanResult.h"

namespace perilymph::gui {

/// The shipped friction of the plans' usual scenario, and the one measured on a tissue simulant.
inline constexpr const char* endosteumFriction = "endosteum";
inline constexpr const char* simulantFriction = "tissue";

/// "friction of endosteum, chosen", "friction of a tissue simulant", "friction soap-50"; of another
/// scenario, "friction of booth".
QString plannedFriction(const planning::PlanRequest& request);

/// planning::bandsHold() in the language of the window: "90 % at friction 0.12".
QString bandsHold(const planning::Plan& plan);

/// A share of an array's simulations: "3 of 16"; from analysis::fewestForPercent on "19 %".
QString shownShare(const analysis::Estimate& fraction, std::size_t draws);
/// The same with the 95 % interval where it is in percent: "19 (11–30) %".
QString shownShareAndInterval(const analysis::Estimate& fraction, std::size_t draws);

}  // namespace perilymph::gui
