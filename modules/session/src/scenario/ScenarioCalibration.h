// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Calibration of a scenario's array.

#include <optional>

#include "perilymph/session/Scenario.h"
#include "scenario/EffectiveText.h"

namespace perilymph::session {

/// The calibration parameters requested by a scenario.
struct AskedCalibration {
  std::string array;  ///< Array of the named calibration; empty without one.
  double stiffnessScale = 1.0;
  std::optional<double> residualCurvature;  ///< If empty, the array's own value is used.
};

/// Reads `calibration` (a shipped name or a file), and `stiffness_scale` and
/// `residual_curvature_fraction`, which take precedence over it. A text with both numbers needs no
/// file.
Result<AskedCalibration> readCalibration(TomlReader& reader, ScenarioKeys& keys,
                                         ScenarioContent& scenario);

/// Applies stiffness scale and curvature to the array. Refuses a calibration of another array.
Result<void> applyCalibration(const AskedCalibration& asked, ScenarioContent& scenario);

}  // namespace perilymph::session
