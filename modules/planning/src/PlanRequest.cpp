// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/planning/PlanRequest.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "perilymph/foundation/Version.h"
#include "perilymph/session/Csv.h"

namespace perilymph::planning {

namespace {

bool takesFew()
{
  const auto changed = replacedByEnvironment();
  return std::find(changed.begin(), changed.end(), fewDraws) != changed.end();
}

}  // namespace

Resolution usualResolution()
{
  return takesFew() ? Resolution{40, milliseconds(10)} : Resolution{};
}

Result<session::Scenario> scenarioOf(const PlanRequest& request, const std::string& array,
                                     const std::string& stopTravel_mm)
{
  session::Overrides changes = {{"array", array}, {"stop_travel_mm", stopTravel_mm}};
  if (request.friction) changes.emplace_back("friction", *request.friction);
  if (request.approach)
    for (const auto& [key, angle] : {std::pair{"approach_tilt_deg", request.approach->tilt},
                                     std::pair{"approach_turn_deg", request.approach->turn}})
      changes.emplace_back(key,
                           session::shortestDecimal(1e-2 * std::round(100.0 * inDegrees(angle))));
  return session::loadScenario(request.scenario, changes);
}

Result<void> checkDraws(std::size_t draws)
{
  if (draws >= (takesFew() ? std::size_t{1} : fewestDraws) && draws <= maxDraws) return {};
  if (draws > maxDraws)
    return Error{"A plan of %1 simulations is too long. Choose %2 to %3.", draws, fewestDraws,
                 maxDraws};
  return Error{
      "A plan of %1 simulations is too short: the lowest and the highest of fewer than %2 hold "
      "less than 88 % of the insertions to come. Choose %2 to %3.",
      draws, fewestDraws, maxDraws};
}

std::size_t usualDraws(bool hasClinicResistance) { return hasClinicResistance ? 512 : 64; }

}  // namespace perilymph::planning
