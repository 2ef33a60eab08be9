// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Transcendental functions that give the same bits on every x86-64 machine. Those of the C library
// select instructions at run time (with or without FMA) and may differ in the last place; every
// computation that affects a result calls these instead. They use only + - * / and sqrt.

#include <cmath>

namespace perilymph {

/// e to the power x. Relative error below 2e-15 for |x| < 700; 0 below, infinity above.
double exponential(double x) noexcept;

/// Natural logarithm of x > 0. Absolute error below 2e-15 max(1, |log x|). NaN for x <= 0.
double logarithm(double x) noexcept;

struct SineCosine {
  double sine;
  double cosine;
};

/// Sine and cosine of an angle [rad], |angle| < 1e5. Absolute error below 1e-15 + 1e-16 |angle|.
/// NaN for larger angles.
SineCosine sineCosine(double angle) noexcept;

/// Angle [rad] of the point (x, y) from the positive x axis, in (-pi, pi]. Absolute error below
/// 2e-15 for coordinates below 1e300. 0 at the origin. Real-time safe.
inline double arcTangent(double y, double x) noexcept
{
  // Reduce to one octant, without branches: the octants of successive calls are unpredictable.
  const double width = std::fabs(x);
  const double height = std::fabs(y);
  const bool isSteep = height > width;
  const double small = isSteep ? width : height;
  const double large = isSteep ? height : width;

  // Above tan(pi/8), turn the point back by pi/4, so that |ratio| <= tan(pi/8).
  constexpr double tangentOfEighth = 0.41421356237309503;
  const bool isTurned = small > tangentOfEighth * large;
  const double turned = isTurned ? 1.0 : 0.0;
  const double divisor = large + turned * small;
  const double ratio = (small - turned * large) / (divisor > 0.0 ? divisor : 1.0);

  // atan(r) / r - 1 = z P(z), z = r^2; interpolated at Chebyshev points of 0 <= z <= tan(pi/8)^2
  // with 60 digits, error below 6e-17 there. Summed as a tree for a shorter dependency chain.
  const double z = ratio * ratio;
  const double z2 = z * z;
  const double z4 = z2 * z2;
  const double low = (-0x1.5555555555546p-2 + z * 0x1.9999999990a9fp-3) +
                     z2 * (-0x1.2492491dd4b23p-3 + z * 0x1.c71c6dd1c9feep-4);
  const double middle = (-0x1.745c7f841cab0p-4 + z * 0x1.3b068efbf3910p-4) +
                        z2 * (-0x1.105e40d46ca9bp-4 + z * 0x1.d5eb9aa01dd64p-5);
  const double high = -0x1.6f4656da14d12p-5 + z * 0x1.74be9ea57def3p-6;
  const double tree = low + z4 * (middle + z4 * high);
  const double reduced = ratio + ratio * (z * tree);

  // Undo the reductions: angle = corner +- reduced.
  constexpr double eighth = 0x1.921fb54442d18p-1;  // pi/4
  const double inEighth = turned * eighth + reduced;
  const double inQuarter = isSteep ? 2.0 * eighth - inEighth : inEighth;
  const double inHalf = x < 0.0 ? 4.0 * eighth - inQuarter : inQuarter;
  return y < 0.0 ? -inHalf : inHalf;
}

/// base to the power exponent, base > 0.
inline double power(double base, double exponent) noexcept
{
  return exponential(exponent * logarithm(base));
}

}  // namespace perilymph
