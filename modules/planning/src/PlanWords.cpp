// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/planning/PlanWords.h"

#include <algorithm>
#include <cmath>

#include "perilymph/figures/Strings.h"
#include "perilymph/foundation/Math.h"
#include "perilymph/foundation/Normal.h"
#include "perilymph/session/Csv.h"

namespace perilymph::planning {

int percentHeld(std::size_t draws)
{
  if (draws == 0) return 0;
  const auto count = static_cast<double>(draws);
  return static_cast<int>(std::lround(100.0 * std::min(0.9, (count - 1.0) / (count + 1.0))));
}

Sentence bandsHold(const Plan& plan)
{
  std::size_t fewest = maxDraws;
  for (const ArrayPlan& each : plan.arrays) fewest = std::min(fewest, each.draws);
  const int held = percentHeld(fewest);
  const auto& [low, high] = plan.friction;
  if (!std::isfinite(low) || !std::isfinite(high)) return Sentence{"%1 % at one friction", held};
  if (plan.frictionSpread > 0.0) {
    const double factor = exponential(halfWidth95 * plan.frictionSpread);
    return Sentence{"%1 % over friction %2 to %3", held, figures::fixed(low / factor, 2),
                    figures::fixed(high * factor, 2)};
  }
  const std::string lowest = session::shortestDecimal(low);
  if (!(low < high)) return Sentence{"%1 % at friction %2", held, lowest};
  return Sentence{"%1 % at friction %2 to %3", held, lowest, session::shortestDecimal(high)};
}

}  // namespace perilymph::planning
