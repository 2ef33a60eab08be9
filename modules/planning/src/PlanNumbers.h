// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// How numbers of a plan are written.

#include <cmath>

namespace perilymph::planning {

/// A number of a result, to six digits: more would be noise.
inline double rounded(double value)
{
  if (value == 0.0 || !std::isfinite(value)) return 0.0;
  const double scale = std::pow(10.0, 5.0 - std::floor(std::log10(std::fabs(value))));
  return std::round(value * scale) / scale;
}

}  // namespace perilymph::planning
