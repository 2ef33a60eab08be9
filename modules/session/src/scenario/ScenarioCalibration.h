#pragma once

// What a scenario says about the calibration of its array.

#include <optional>

#include "perilymph/session/Scenario.h"
#include "scenario/EffectiveText.h"

namespace perilymph::session {

/// The fitted numbers that a scenario asks for.
struct AskedCalibration {
  std::string array;  ///< That a named calibration was fitted for; empty without one.
  double stiffnessScale = 1.0;
  std::optional<double> residualCurvature;  ///< Without a value the array's own holds.
};

/// Reads `calibration` (a shipped name or a file), and `stiffness_scale` and
/// `residual_curvature_fraction`, which go before what a calibration says. A text that gives both
/// numbers needs no file.
Result<AskedCalibration> readCalibration(TomlReader& reader, ScenarioKeys& keys,
                                         Scenario& scenario);

/// Sets the array's stiffness and curvature as asked. Refuses a calibration of another array.
Result<Done> applyCalibration(const AskedCalibration& asked, Scenario& scenario);

}  // namespace perilymph::session
