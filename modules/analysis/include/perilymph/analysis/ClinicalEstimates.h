// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Clinical formulas based on A and B, side by side because their results differ.

#include <vector>

#include "perilymph/analysis/AnatomyMeasures.h"
#include "perilymph/foundation/Units.h"

namespace perilymph::analysis {

/// The cochlear duct length (anatomy's DuctLength.h) with formula, source and the formula's error.
Measure ductLength(const char* key, Length a, Length b);
/// Length of its first two turns: 3.65 (A - 1 mm) (Alexiades 2015).
Length alexiadesTwoTurns(Length a);
/// Length of the outer wall to an angle: 2.62 A ln(1 + angle / 235 deg) (Escude 2006).
Length escudeOuterWall(Length a, Angle angle);

/// These, the basal turn and the duct length by the formulas that ductLength() does not use, and the number
/// of turns predicted from A and B, each with formula and source.
std::vector<Measure> clinicalEstimates(Length a, Length b);

}  // namespace perilymph::analysis
