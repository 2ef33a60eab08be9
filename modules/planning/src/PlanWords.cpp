// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/planning/PlanWords.h"

#include <algorithm>
#include <cmath>

#include "perilymph/figures/Strings.h"
#include "perilymph/foundation/Math.h"
#include "perilymph/foundation/Normal.h"
#include "perilymph/planning/PlanSummary.h"
#include "perilymph/session/Csv.h"

namespace perilymph::planning {

namespace {

/// From this number of simulations on, 5 and 95 % lie within them (bandOf()).
constexpr std::size_t fewestInside = 19;

}  // namespace

Sentence bandsShare(const Plan& plan)
{
  std::size_t fewest = maxDraws;
  for (const ArrayPlan& each : plan.arrays) fewest = std::min(fewest, each.draws);
  if (fewest >= fewestForBand) return Sentence{"90 %"};
  if (fewest == 1) return Sentence{"1 simulation"};
  return fewest < fewestInside ? Sentence{"lowest to highest of %1 simulations", fewest}
                               : Sentence{"5 to 95 % of %1 simulations", fewest};
}

Sentence bandsHold(const Plan& plan)
{
  const Sentence held = bandsShare(plan);
  const auto& [low, high] = plan.friction;
  if (!std::isfinite(low) || !std::isfinite(high)) return Sentence{"%1 at one friction", held};
  if (plan.frictionSpread > 0.0) {
    const double factor = exponential(halfWidth95 * plan.frictionSpread);
    return Sentence{"%1 over friction %2 to %3", held, figures::fixed(low / factor, 2),
                    figures::fixed(high * factor, 2)};
  }
  const std::string lowest = session::shortestDecimal(low);
  if (!(low < high)) return Sentence{"%1 at friction %2", held, lowest};
  return Sentence{"%1 at friction %2 to %3", held, lowest, session::shortestDecimal(high)};
}

}  // namespace perilymph::planning
