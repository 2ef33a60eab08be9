#pragma once

// Which tone belongs to which place of the cochlea.

#include "perilymph/foundation/Units.h"

namespace perilymph::analysis {

/// Frequency [Hz] of a place on the organ of Corti (Greenwood 1990, human):
///
///     f = 165.4 (10^(2.1 x) - 0.88)
///
/// @param fromApex  Share x of the organ of Corti's length, 0 at the apex and 1 at the base; places
///                  beyond both ends count as the ends.
double greenwoodFrequency(double fromApex);

/// Frequency [Hz] of a place on the spiral ganglion, by the angle from the round window
/// (Stakhovskaya et al. 2007, every quarter turn to 720 degrees). Between them monotone cubics in
/// the logarithm of the frequency; angles beyond both ends count as the ends.
double spiralGanglionFrequency(Angle angle);

}  // namespace perilymph::analysis
