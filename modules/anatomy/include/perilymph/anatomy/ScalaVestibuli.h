// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The scala vestibuli, for pictures and files only: nothing is simulated in it.

#include "perilymph/anatomy/ScalaTympani.h"
#include "perilymph/anatomy/Surface.h"

namespace perilymph::anatomy {

/// The scala vestibuli (scala media included) as the mirror image of the scala tympani in its own
/// roof: the same spiral, the same section upside down at every angle.
///
/// From the round window to the apex, closed there and open toward the vestibule. Derived, not
/// measured (confidence low): no section data were available. Where the mirrored section intersects
/// the turn above, the overlap remains.
Surface vestibuliSurface(const ScalaTympani& scala, int maxTriangles);

}  // namespace perilymph::anatomy
