// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Tonotopy: characteristic frequency by position in the cochlea.

#include "perilymph/foundation/Units.h"

namespace perilymph::analysis {

/// Frequency [Hz] of a position on the organ of Corti (Greenwood 1990, human):
///
///     f = 165.4 (10^(2.1 x) - 0.88)
///
/// @param fromApex  Fraction x of the organ of Corti's length, 0 at the apex and 1 at the base;
/// clamped.
double greenwoodFrequency(double fromApex);

/// Frequency [Hz] of a position on the spiral ganglion, by the angle from the round window
/// (Stakhovskaya et al. 2007, every quarter turn to 720 degrees). Monotone cubic interpolation of
/// the logarithm of the frequency; the angle is clamped.
double spiralGanglionFrequency(Angle angle);

/// Semitones from one frequency [Hz] up to another; 12 are an octave.
double semitones(double from_Hz, double to_Hz);

}  // namespace perilymph::analysis
