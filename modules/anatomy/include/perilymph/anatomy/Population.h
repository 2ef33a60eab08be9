// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Variation of human cochleae: the four half-diameters of the basal turn over 138 cochleae, and the
// spiral derived from them (Pietsch et al. 2017, Sci Rep; confidence medium: constants taken from
// public code that cites them).

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "perilymph/foundation/Units.h"

namespace perilymph::anatomy {

/// Distances from the modiolar axis to the outer wall at quarter turns of the basal turn: A1 at 0,
/// B1 at 90, A2 at 180 and B2 at 270 degrees [m].
struct HalfDiameters {
  double a1, b1, a2, b2;

  Length a() const { return Length::fromSi(a1 + a2); }
  Length b() const { return Length::fromSi(b1 + b2); }
};

/// Half-diameters of the mean cochlea.
HalfDiameters meanHalfDiameters();

/// Covariance of A1, B1, A2, B2 [m^2].
std::array<std::array<double, 4>, 4> halfDiameterCovariance();

/// The most likely half-diameters of a cochlea with known A and B: their conditional mean.
HalfDiameters likeliestHalfDiameters(Length a, Length b);

/// The same with what A and B leave open, how A1 and A2 share A and B1 and B2 share B, that many
/// conditional standard deviations away: two independent standard normal deviates give the
/// conditional normal distribution of the population.
HalfDiameters individualHalfDiameters(Length a, Length b, std::array<double, 2> deviates);

/// Radius of the outer wall at an angle from the round window, up to the turn angle [m].
double outerWallRadius(const HalfDiameters& half, Angle angle);

/// Total angle through which the cochlea turns.
Angle turnAngle(const HalfDiameters& half);

/// Half-diameters drawn from the population's normal distribution: the same for the same seed on
/// every machine.
HalfDiameters sampleHalfDiameters(std::uint64_t seed);

/// Mean, standard deviation and limits of one diameter over the population.
struct Spread {
  Length mean, standardDeviation, low, high;  ///< Limits are four standard deviations from the
                                              ///< mean.
};
Spread spreadOfA();
Spread spreadOfB();

/// Mean, standard deviation and limits of B in cochleae with a known A: the conditional normal
/// distribution.
Spread expectedB(Length a);

/// Limits of the height H, which depends on its definition: from four standard deviations below a
/// clinical mean (3.26, SD 0.24 mm, Medan) to the highest whole cochlea (4.8 mm, Erixon 2009).
Spread limitsOfH();

/// Whether B is farther than 3.5 conditional standard deviations from what fits A, or H outside
/// `limitsOfH()` by more than three standard errors: a malformed cochlea, a stretched scan or a
/// wrong unit.
bool areOutOfProportion(Length a, Length b, Length h, Length errorOfB = {}, Length errorOfH = {});

}  // namespace perilymph::anatomy
