// SPDX-License-Identifier: BSD-3-Clause
#include "PublishedRun.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>
#include <stdexcept>

#include "perilymph/mechanics/advance.h"
#include "perilymph/session/Scenario.h"

namespace perilymph::test {
namespace {

std::string inText(double value)
{
  std::ostringstream text;
  text << value;
  return text.str();
}

session::Scenario scenarioOf(const Resolution& resolution)
{
  session::Overrides overrides = {{"nodes", std::to_string(resolution.nodes)},
                                  {"dt_ms", inText(resolution.timeStep_ms)},
                                  {"speed_mm_s", inText(resolution.speed_mm_s)}};
  overrides.insert(overrides.end(), resolution.more.begin(), resolution.more.end());
  const auto scenario = session::loadScenario(resolution.scenario, overrides);
  if (!scenario) throw std::runtime_error(scenario.error().message);
  return *scenario;
}

std::shared_ptr<const mechanics::InsertionModel> modelOf(const session::Scenario& scenario)
{
  // the same at every resolution
  static std::map<anatomy::AnatomySource, decltype(session::buildAnatomy(scenario))> scalas;
  const auto& scala =
      scalas.try_emplace(scenario.anatomy(), session::buildAnatomy(scenario)).first->second;
  if (!scala) throw std::runtime_error(scala.error().message);
  const auto model = session::buildModel(scenario, *scala);
  if (!model) throw std::runtime_error(model.error().message);
  return *model;
}

}  // namespace

std::vector<double> forceOverTravel(const Resolution& resolution)
{
  const session::Scenario scenario = scenarioOf(resolution);
  const auto model = modelOf(scenario);
  mechanics::InsertionState state(*model);
  mechanics::Drive drive;
  drive.handAxis_W = model->startAxis_W;
  drive.handCurl_W = model->startCurl_W;

  const double travelOfTick = scenario.speed().si() * model->timeStep;
  const long ticksOfSample = std::lround(sampleTravel / travelOfTick);
  const long samples = std::lround(scenario.stopTravel().si() / sampleTravel);
  std::vector<double> force;
  for (long tick = 1; tick <= samples * ticksOfSample; ++tick) {
    drive.handPosition_W =
        model->startBase_W + (static_cast<double>(tick) * travelOfTick) * model->startAxis_W;
    mechanics::advance(*model, state, drive);
    if (tick % ticksOfSample == 0) force.push_back(state.readings.axialForce);
  }
  return force;
}

Spread spreadOf(const std::vector<std::vector<double>>& runs)
{
  Spread spread;
  for (std::size_t i = 0; i < runs.back().size(); ++i) {
    double low = runs.back()[i], high = low;
    for (const std::vector<double>& run : runs) {
      low = std::min(low, run[i]);
      high = std::max(high, run[i]);
    }
    spread.peak = std::max(spread.peak, runs.back()[i]);
    if (high - low <= spread.maximum) continue;
    spread.maximum = high - low;
    spread.travel = sampleTravel * static_cast<double>(i + 1);
  }
  return spread;
}

}  // namespace perilymph::test
