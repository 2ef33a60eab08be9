#pragma once

// Two unknowns by two residuals: the Gauss-Newton method with bounds.

#include <functional>

#include "perilymph/foundation/Result.h"

namespace perilymph::analysis {

/// Two unknowns, or two residuals.
struct TwoNumbers {
  double a = 0.0, b = 0.0;
};

/// Where the solution is looked for.
struct TwoBounds {
  TwoNumbers low, high;
  TwoNumbers step;  ///< For differences; also the scale on which they matter.
  int raster = 1;   ///< So many even places of each number are tried first; the best one begins.
};

/// What the fit found.
struct GaussNewton2 {
  TwoNumbers at;
  TwoNumbers residual;
  /// Standard errors for residuals of unit variance; 0 where a bound holds the number.
  TwoNumbers standardDeviation;
  int trials = 0;
};

using TwoResiduals = std::function<Result<TwoNumbers>(const TwoNumbers&)>;

/// The two numbers that minimize the sum of squares of two residuals within bounds, by the damped
/// Gauss-Newton method from the best place of a raster.
Result<GaussNewton2> gaussNewton2(const TwoResiduals& residuals, TwoNumbers start,
                                  const TwoBounds& bounds);

}  // namespace perilymph::analysis
