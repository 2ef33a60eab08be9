// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Clinical formulas based on A and B, side by side because their results differ.

#include <vector>

#include "perilymph/analysis/AnatomyMeasures.h"
#include "perilymph/foundation/Units.h"

namespace perilymph::analysis {

/// Length of the cochlear duct along the organ of Corti: 4.16 A - 4 mm (Alexiades 2015).
Length alexiadesDuctLength(Length a);
/// Length of its first two turns: 3.65 (A - 1 mm) (Alexiades 2015).
Length alexiadesTwoTurns(Length a);
/// Length of the outer wall to an angle: 2.62 A ln(1 + angle / 235 deg) (Escude 2006).
Length escudeOuterWall(Length a, Angle angle);
/// Length of the outer wall of the basal turn, by its ellipse and circle: 1.18 A + 2.69 B -
/// sqrt(0.72 A B) (Schurzig 2018). With A and B each 1 mm shorter, along the organ of Corti.
Length ellipticCircularBasalTurn(Length a, Length b);
/// Length of the cochlear duct along the organ of Corti: 1.71 times its basal turn + 0.18 mm
/// (Schurzig 2018).
Length ellipticCircularDuctLength(Length a, Length b);

/// All of them and the number of turns predicted from A and B, each with formula and source.
std::vector<Measure> clinicalEstimates(Length a, Length b);

}  // namespace perilymph::analysis
