// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Numbers in the tables of a comparison.

#include <string>

#include "perilymph/foundation/Units.h"
#include "perilymph/session/Csv.h"

namespace perilymph::analysis {

/// A number as the next field of a row, with the comma before it.
inline std::string nextField(double value) { return "," + session::shortestDecimal(value); }

/// From SI to the units of tables.
inline double asMillimeters(double length) { return inMillimeters(meters(length)); }
inline double asDegrees(double angle) { return inDegrees(radians(angle)); }

}  // namespace perilymph::analysis
