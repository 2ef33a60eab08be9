#pragma once

// From a scenario to the engine: the same for a run and for its replay.

#include <algorithm>
#include <memory>
#include <stdexcept>

#include "perilymph/session/Recording.h"
#include "perilymph/session/Scenario.h"

namespace perilymph::session {

/// @param facts  What the device asks of the engine: its period, its bounds of force, reach,
///               stiffness and damping. A hand that feels forces is coupled by a spring.
inline Result<std::unique_ptr<haptics::InsertionEngine>> makeEngine(
    const Scenario& scenario, std::shared_ptr<const mechanics::InsertionModel> model,
    const RecordingFacts& facts)
{
  haptics::EngineSettings settings = scenario.engine;
  settings.samplePeriod = facts.samplePeriod;
  settings.safety.maxForce = std::min(settings.safety.maxForce, facts.maxForce);
  settings.safety.offTime = facts.offTime;
  settings.safety.reach = facts.reach;
  if (facts.feelsForce) settings.coupling = mechanics::Coupling::spring;
  settings.maxStiffness = facts.maxStiffness;
  settings.maxDamping = facts.maxDamping;
  try {
    return std::make_unique<haptics::InsertionEngine>(std::move(model), settings);
  } catch (const std::invalid_argument& error) {
    return Error{scenario.name + " cannot be run: " + error.what()};
  }
}

}  // namespace perilymph::session
