// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Travel values for messages and tables.

#include <cmath>

#include "perilymph/foundation/Units.h"

namespace perilymph::analysis {

/// A travel in millimeters without the rounding errors of a multiple of the step.
inline double roundedMillimeters(double travel)
{
  return std::round(inMillimeters(meters(travel)) * 1e6) / 1e6;
}

}  // namespace perilymph::analysis
