// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/planning/PlanWords.h"

#include <algorithm>
#include <cmath>

#include "perilymph/session/Csv.h"

namespace perilymph::planning {

int percentHeld(std::size_t draws)
{
  if (draws == 0) return 0;
  const auto count = static_cast<double>(draws);
  return static_cast<int>(std::lround(100.0 * std::min(0.9, (count - 1.0) / (count + 1.0))));
}

std::string bandsHold(const Plan& plan)
{
  std::size_t fewest = maxDraws;
  for (const ArrayPlan& each : plan.arrays) fewest = std::min(fewest, each.draws);
  const std::string held = std::to_string(percentHeld(fewest)) + " % at ";
  const auto& [low, high] = plan.friction;
  if (!std::isfinite(low) || !std::isfinite(high)) return held + "one friction";
  const std::string coefficient = session::shortestDecimal(low);
  return held + "friction " +
         (low < high ? coefficient + " to " + session::shortestDecimal(high) : coefficient);
}

}  // namespace perilymph::planning
