#pragma once

// What the engine is told: the same in a run and in its replay.

#include "perilymph/session/Scenario.h"

namespace perilymph::session {

/// @param samplePeriod  Of the device [s].
/// @param mostForce     The lower limit of program and device [N].
inline haptics::EngineSettings engineSettings(const Scenario& scenario, double samplePeriod,
                                              double mostForce)
{
  haptics::EngineSettings settings = scenario.engine;
  settings.samplePeriod = samplePeriod;
  settings.safety.mostForce = mostForce;
  return settings;
}

}  // namespace perilymph::session
