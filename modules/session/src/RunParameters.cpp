// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/session/RunParameters.h"

#include <algorithm>

#include "perilymph/haptics/CouplingLimit.h"

namespace perilymph::session {

RunParameters runParameters(const haptics::SafetyLimits& safety, const device::DeviceTraits& traits,
                            double timeStep)
{
  const haptics::SafetyLimits limits = haptics::limitsFor(safety, traits);
  const haptics::CouplingLimit coupling = haptics::couplingLimit(traits, timeStep);
  RunParameters run;
  run.samplePeriod = traits.nominalPeriod;
  run.maxForce = limits.maxForce;
  run.offTime = limits.offTime;
  run.reach = limits.reach;
  run.feelsForce = traits.rendersForce;
  run.maxStiffness = coupling.stiffness;
  run.maxDamping = coupling.damping;
  run.restAfter = recordedWait;
  run.restMotion = recordedMotion;
  // A script or a mouse moves as slowly as it is told, a hand does not.
  if (traits.rendersForce) run.restHandMotion = recordedHandMotion;
  return run;
}

haptics::EngineSettings withRunParameters(haptics::EngineSettings settings,
                                          const RunParameters& run)
{
  settings.samplePeriod = run.samplePeriod;
  settings.safety.maxForce = std::min(settings.safety.maxForce, run.maxForce);
  settings.safety.offTime = run.offTime;
  settings.safety.reach = run.reach;
  if (run.feelsForce) settings.coupling = mechanics::Coupling::spring;
  settings.maxStiffness = run.maxStiffness;
  settings.maxDamping = run.maxDamping;
  settings.restAfter = run.restAfter;
  settings.restMotion = run.restMotion;
  settings.restHandMotion = run.restHandMotion;
  return settings;
}

}  // namespace perilymph::session
