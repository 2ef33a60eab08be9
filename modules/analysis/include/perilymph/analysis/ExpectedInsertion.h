// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Where a fully inserted array ends, from geometry alone.

#include <vector>

#include "perilymph/analysis/AnatomyMeasures.h"
#include "perilymph/anatomy/ScalaTympani.h"
#include "perilymph/electrode/ArrayDesign.h"

namespace perilymph::analysis {

/// Angular insertion depth ("angular_insertion_depth_deg") and cochlear coverage
/// ("coverage_percent") of a straight array that is inserted from the round window to its full
/// length. Empty for a precurved one, whose distance from the modiolus geometry does not tell.
///
/// The array lies along the lateral wall, its axis half a mean diameter inside it. Coverage is the
/// fraction of the organ-of-Corti path up to that angle. Real insertions end earlier: the marker
/// stays outside, and not all of the array touches the wall. At the last section, if the array is
/// longer.
std::vector<Measure> expectedInsertion(const anatomy::ScalaTympani& scala,
                                       const electrode::ArrayDesign& array);

/// The angle at which a path along the lateral wall, inside it by a distance, has a length.
Angle angleAlongLateralWall(const anatomy::ScalaTympani& scala, Length length, Length inside);

}  // namespace perilymph::analysis
