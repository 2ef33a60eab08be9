#pragma once

// Transcendental functions that give the same bits on every x86-64 machine. The C library's choose
// their instructions at run time (with or without FMA) and may differ in the last place; anything
// that reaches a result calls these instead. Only + - * / and sqrt inside.

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
SineCosine sineCosine(double angle) noexcept;

/// Angle [rad] of the point (x, y) from the positive x axis, in (-pi, pi]. Absolute error below
/// 2e-15. 0 at the origin. Real-time safe.
double arcTangent(double y, double x) noexcept;

/// base to the power exponent, base > 0.
inline double power(double base, double exponent) noexcept
{
  return exponential(exponent * logarithm(base));
}

}  // namespace perilymph
