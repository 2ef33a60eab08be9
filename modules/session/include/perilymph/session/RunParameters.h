// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Device-dependent parameters of the engine in a run, stored in a recording for its replay.

#include <limits>

#include "perilymph/device/HapticDevice.h"
#include "perilymph/haptics/InsertionEngine.h"

namespace perilymph::session {

/// Parameters of an engine that depend on the device, in addition to those of the scenario.
struct RunParameters {
  double samplePeriod = 1e-3;  ///< EngineSettings::samplePeriod [s].
  double maxForce = 3.3;       ///< SafetyLimits::maxForce [N].
  double offTime = 3e-3;       ///< SafetyLimits::offTime [s].
  double reach = 0.0;          ///< SafetyLimits::reach [m].
  bool feelsForce = false;     ///< The device renders forces: the coupling is a spring.
  /// Equal to the EngineSettings of the same names [N/m], [N.s/m].
  double maxStiffness = std::numeric_limits<double>::infinity();
  double maxDamping = std::numeric_limits<double>::infinity();
  /// EngineSettings::restAfter [s]; infinite in recordings of programs that knew no rest.
  double restAfter = std::numeric_limits<double>::infinity();
  /// EngineSettings::restMotion [m]; 0 in recordings of programs in which a held device never rested.
  double restMotion = 0.0;
  /// EngineSettings::restHandMotion [m]; 0 in recordings of programs in which an insertion never
  /// rested, and for devices that are no hand's.
  double restHandMotion = 0.0;
};

/// Time without motion after which an insertion rests and is not recorded [s]: long enough to see
/// in a replay that nothing follows (chosen; no source).
inline constexpr double recordedWait = 3.0;

/// Motion of the array that ends the time without motion [m]: above one encoder step of 0.055 mm of
/// a haptic device (SampleValidator::velocityLag).
inline constexpr double recordedMotion = 0.06e-3;

/// Motion of a hand at a haptic device while it inserts that ends the time without motion [m]: above
/// one encoder step in each of two directions; a hand trembles by as much (choice, low).
inline constexpr double recordedHandMotion = 0.1e-3;

/// Parameters of a run with a device.
///
/// @param safety    Limits of the scenario; the device may lower the maximum force.
/// @param traits    Traits of the open device, with its measured delay.
/// @param timeStep  Time step of the model [s].
RunParameters runParameters(const haptics::SafetyLimits& safety, const device::DeviceTraits& traits,
                            double timeStep);

/// The engine settings of a scenario combined with the parameters of a run: the lower one of the
/// two force limits; a device that renders force is coupled by a spring.
haptics::EngineSettings withRunParameters(haptics::EngineSettings settings,
                                          const RunParameters& run);

}  // namespace perilymph::session
