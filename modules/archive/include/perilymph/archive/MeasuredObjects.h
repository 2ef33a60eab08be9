// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// What is written of a measured cochlea, from its measures.

#include <string>

#include "perilymph/archive/MeasurementReport.h"
#include "perilymph/archive/Segmentation.h"
#include "perilymph/ct/Measures.h"

namespace perilymph::archive {

/// A, B, H and, where it is given, the duct length, each with half of its 95 % interval.
MeasurementReport reportOf(const ct::CochleaMeasures& measures);

/// The fitted wall as a tube.
Lumen lumenOf(const ct::CochleaMeasures& measures);

/// What the picture of the measures shows, with their values, ASCII.
std::string pictureDescription(const ct::CochleaMeasures& measures);

}  // namespace perilymph::archive
