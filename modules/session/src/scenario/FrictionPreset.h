// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// A friction preset: the text file named by a scenario's `friction`.

#include <string>
#include <vector>

#include "perilymph/foundation/Result.h"

namespace perilymph::session {

/// Coefficients of friction in the units of their file. The files in `resources/friction/` state
/// source and confidence of each.
struct FrictionPreset {
  double staticCoefficient = 0.0;
  double kineticCoefficient = 0.0;  ///< With a table by speed: its minimum.
  double stoppingCoefficient = 0.0;
  double stribeck_mm_s = 0.1;  ///< Choice: below the speeds of hands and of the published test rig.
  std::vector<double> speed_mm_s;
  std::vector<double> coefficient;  ///< At each speed.
};

/// Reads a preset by a shipped name or a path.
Result<FrictionPreset> loadFriction(const std::string& nameOrFile);

}  // namespace perilymph::session
