// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Numbers of the published carrier that both models of the array share (Todd and Naghdy, section
// II.D; confidence high).

#include "perilymph/mechanics/PointSet.h"

namespace perilymph::mechanics {

/// Mass of array and tweezers together, weighed [kg].
inline constexpr double publishedMass = 0.0178943;

/// Length of the carrier in the scala when fully inserted [m].
inline constexpr double publishedDepth = 22e-3;

/// Length of wall that the stiffness of one of the twelve sample points represents (the paper's
/// numbers; the spacing is ours, medium) [m].
inline constexpr double samplePointSpacing = publishedDepth / publishedPoints;

}  // namespace perilymph::mechanics
