#pragma once

// From a scenario to the engine: the same for a run and for its replay.

#include <algorithm>
#include <memory>
#include <stdexcept>

#include "perilymph/session/Scenario.h"

namespace perilymph::session {

/// @param samplePeriod  Of the device [s].
/// @param mostForce     Greatest force shown, where the device's own limit is lower [N].
inline Result<std::unique_ptr<haptics::InsertionEngine>> makeEngine(
    const Scenario& scenario, std::shared_ptr<const mechanics::InsertionModel> model,
    double samplePeriod, double mostForce)
{
  haptics::EngineSettings settings = scenario.engine;
  settings.samplePeriod = samplePeriod;
  settings.safety.mostForce = std::min(settings.safety.mostForce, mostForce);
  try {
    return std::make_unique<haptics::InsertionEngine>(std::move(model), settings);
  } catch (const std::invalid_argument& mistake) {
    return Error{scenario.name + " cannot be run: " + mistake.what()};
  }
}

}  // namespace perilymph::session
