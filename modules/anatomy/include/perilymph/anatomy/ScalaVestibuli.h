#pragma once

// The neighbor above the basilar membrane, for pictures and for files: nothing is simulated in it.

#include "perilymph/anatomy/ScalaTympani.h"
#include "perilymph/anatomy/Surface.h"

namespace perilymph::anatomy {

/// The scala vestibuli (with the scala media, which is not told apart) as the mirror image of the
/// scala tympani in its own roof: the same spiral, at every angle the same section upside down.
///
/// From the round window to the apex, closed there and open toward the vestibule. Derived, not
/// measured (confidence low): no table of its sections was at hand. Where the mirrored section
/// would reach into the turn above it, it still does.
Surface vestibuliSurface(const ScalaTympani& scala, int maxTriangles);

}  // namespace perilymph::anatomy
