// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The friction that a plan computes with, what its bands hold and shares of its simulations, in words.

#include <QString>

#include "perilymph/planning/PlanResult.h"

namespace perilymph::gui {

/// The shipped friction of the plans' usual scenario, the former one, and the one measured on a tissue
/// simulant.
inline constexpr const char* estimatedFriction = "estimate-from-pig-tissue";
inline constexpr const char* endosteumFriction = "endosteum";
inline constexpr const char* simulantFriction = "tissue";

/// The friction of a request: "friction estimated from pig tissue", "friction of a tissue
/// simulant", "friction soap-50"; of another scenario, "friction of booth".
QString plannedFriction(const planning::PlanRequest& request);
/// The friction that a plan was made with, perhaps by a former version with another default.
QString plannedFriction(const planning::Plan& plan);

/// planning::bandsHold() in the language of the window: "90 % over friction 0.08 to 0.33".
QString bandsHold(const planning::Plan& plan);

/// planning::bandsShare() in the language of the window: "90 %".
QString bandsShare(const planning::Plan& plan);
/// The median and band of a difference, with signs: "+35 (-20 to +90)".
QString differenceText(const planning::Band& band);

/// A share of an array's simulations: "3 of 16"; from analysis::fewestForPercent on "19 %".
QString shownShare(const analysis::Estimate& fraction, std::size_t draws);
/// The same with the 95 % interval where it is in percent: "19 (11–30) %".
QString shownShareAndInterval(const analysis::Estimate& fraction, std::size_t draws);

}  // namespace perilymph::gui
