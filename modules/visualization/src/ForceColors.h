#pragma once

// The one map from wall force to color: transparent, yellow, red, in even steps for the eye.

#include "Palette.h"

namespace perilymph::visualization {

/// Force of the wall on one millimeter of array at which the map ends [mN/mm]. Fixed, so that
/// pictures of different insertions compare. A choice: about what the published array shows behind
/// the opening when its tip meets the basal turn.
inline constexpr double maxWallForce_mN_mm = 50.0;

/// Color and opacity for a force per length; the end of the map beyond its end.
Rgba forceColor(double force_mN_mm);

}  // namespace perilymph::visualization
