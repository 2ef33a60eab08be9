#pragma once

// What the device asks of the engine in a run. A recording keeps it, so that a replay is given the
// same.

#include <limits>

#include "perilymph/device/HapticDevice.h"
#include "perilymph/haptics/InsertionEngine.h"

namespace perilymph::session {

/// Parameters of an engine that follow from the device, beside those of the scenario.
struct RunParameters {
  double samplePeriod = 1e-3;  ///< EngineSettings::samplePeriod [s].
  double maxForce = 3.3;       ///< SafetyLimits::maxForce [N].
  double offTime = 3e-3;       ///< SafetyLimits::offTime [s].
  double reach = 0.0;          ///< SafetyLimits::reach [m].
  bool feelsForce = false;     ///< The device renders forces: the coupling is a spring.
  /// EngineSettings of the same names [N/m], [N.s/m].
  double maxStiffness = std::numeric_limits<double>::infinity();
  double maxDamping = std::numeric_limits<double>::infinity();
};

/// Parameters of a run with a device.
///
/// @param safety    Limits of the scenario; the device may lower the force.
/// @param traits    Traits of the open device, with its measured delay.
/// @param timeStep  Time step of the model [s].
RunParameters runParameters(const haptics::SafetyLimits& safety, const device::DeviceTraits& traits,
                            double timeStep);

/// A scenario's settings of the engine with the parameters of a run: the lower of the two bounds of
/// force; a device that renders forces is coupled by a spring.
haptics::EngineSettings withRunParameters(haptics::EngineSettings settings,
                                          const RunParameters& run);

}  // namespace perilymph::session
