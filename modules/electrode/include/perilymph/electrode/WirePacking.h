// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// How tightly the wires of an array are packed: c of the model of stiffness that shipped arrays follow,
//   EI(s) = E_s I(s) + E_w I_w (N(s) + c N(s)^2)
// (guide, method.md). No maker publishes c: scenarios of surgery state one value for all straight arrays,
// plans and the clinical table draw it.

#include <optional>

#include "perilymph/electrode/ArrayDesign.h"

namespace perilymph::electrode {

/// N(s): one wire for each contact nearer to the tip, linear between contacts and at least 1.
double wiresAt(const ArrayDesign& array, Length fromTip);

/// c of an array's bending stiffness, by least squares over its knots; none if the array states no wires or the model
/// does not give the stiffness to 10 % at every knot, as where it was measured or fitted, and none of an array with a
/// stylet or sheath: c would change the moment with which it curls, which that part has to hold. None of
/// wires that yield either: the lower values of c stand for what yielding takes, which would count twice.
std::optional<double> wirePacking(const ArrayDesign& array);

/// The array with another c: its bending stiffness differs by E_w I_w N(s)^2 times the difference. An array
/// that has no c by wirePacking() stays as it is.
ArrayDesign withWirePacking(ArrayDesign array, double packing);

}  // namespace perilymph::electrode
