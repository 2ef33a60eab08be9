// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// A shipped run at selectable resolutions.

#include <string>
#include <vector>

#include "perilymph/session/Scenario.h"

namespace perilymph::test {

/// Scenario, and resolution parameters that must not matter.
struct Resolution {
  std::string scenario = "contour-published";
  double speed_mm_s = 2.0;
  int nodes = 100;
  double timeStep_ms = 1.0;
  session::Overrides more = {};  ///< Other keys of the scenario.
};

/// Travel between two samples [m]: one tick of the longest time step at 2 mm/s.
inline constexpr double sampleTravel = 0.02e-3;

/// Axial force [N] of the scenario, every `sampleTravel` from the first to the last, whatever the
/// time step.
/// @throws std::runtime_error with a sentence if the scenario cannot be built.
std::vector<double> forceOverTravel(const Resolution& resolution);

/// Maximum difference of runs at the same travel.
struct Spread {
  double maximum = 0.0;  ///< Maximum over all depths of highest minus lowest force [N].
  double travel = 0.0;   ///< Travel of the maximum [m].
  double peak = 0.0;     ///< Maximum force of the last run [N].
};

/// The spread of runs, the finest last.
Spread spreadOf(const std::vector<std::vector<double>>& runs);

}  // namespace perilymph::test
