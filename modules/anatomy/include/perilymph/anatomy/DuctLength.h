// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Length of the cochlear duct along the organ of Corti: one formula for all pages, files and reports, that
// which uses both A and B, the elliptic-circular approximation (Schurzig et al. 2018; constants
// unverified, confidence medium: on the average scala tympani of Froehlich et al. 2024 the basal turn is
// 22.75 mm, and 22.82 mm are measured).

#include "perilymph/anatomy/Patient.h"
#include "perilymph/foundation/Units.h"

namespace perilymph::anatomy {

/// Length of the outer wall of the basal turn, by its ellipse and circle: 1.18 A + 2.69 B -
/// sqrt(0.72 A B). With A and B each 1 mm shorter, along the organ of Corti.
Length ellipticCircularBasalTurn(Length a, Length b);

/// Length of the cochlear duct along the organ of Corti: 1.71 times its basal turn + 0.18 mm.
Length ellipticCircularDuctLength(Length a, Length b);

/// The same from A alone: 4.16 A - 4 mm (Alexiades et al. 2015).
Length ductLengthFromA(Length a);

/// Standard deviation of the length from A and B that their errors e cause, of correlation r:
/// d_a = L(a + e_a, b) - L(a, b), d_b likewise, sqrt(d_a^2 + d_b^2 + 2 r d_a d_b). Without that of the
/// formula.
Length ductLengthError(Length a, Length b, const BasalTurnErrors& errors);

/// Standard deviation that stands for the choice of the formula: the 95 % interval of the length from A and
/// B holds that from A alone. Both differ by millimeters in single ears (Timm et al. 2018).
Length ductLengthFormulaError(Length a, Length b);

}  // namespace perilymph::anatomy
