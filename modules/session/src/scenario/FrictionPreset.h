#pragma once

// Friction as a text file: what a scenario's `friction` names.

#include <string>
#include <vector>

#include "perilymph/foundation/Result.h"

namespace perilymph::session {

/// Coefficients of friction in the units of their file. In `resources/friction/`, each with source
/// and confidence.
struct FrictionPreset {
  double staticCoefficient = 0.0;
  double kineticCoefficient = 0.0;  ///< With a table by speed: its least value.
  double stoppingCoefficient = 0.0;
  double stribeck_mm_s = 0.1;  ///< Choice: below the speeds of hands and of the published rig.
  std::vector<double> speed_mm_s;
  std::vector<double> coefficient;  ///< At each speed.
};

/// Reads a preset by a shipped name or a file's path.
Result<FrictionPreset> loadFriction(const std::string& nameOrFile);

}  // namespace perilymph::session
