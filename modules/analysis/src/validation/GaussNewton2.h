// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Bounded Gauss-Newton method for two unknowns and two residuals.

#include <functional>

#include "perilymph/foundation/Result.h"

namespace perilymph::analysis {

/// Two unknowns, or two residuals.
struct TwoNumbers {
  double a = 0.0, b = 0.0;
};

/// Bounds of the solution.
struct TwoBounds {
  TwoNumbers low, high;
  TwoNumbers step;  ///< Step of finite differences; also the scale of the tolerance.
  int raster = 1;   ///< Number of equally spaced start values of each unknown; the best one is
                    ///< used.
};

/// Result of the fit.
struct GaussNewton2 {
  TwoNumbers at;
  TwoNumbers residual;
  /// Standard errors for residuals of unit variance; 0 for an unknown at a bound.
  TwoNumbers standardDeviation;
  int trials = 0;
};

using TwoResiduals = std::function<Result<TwoNumbers>(const TwoNumbers&)>;

/// Minimizes the sum of squares of two residuals within bounds, by the damped Gauss-Newton method
/// from the best point of a grid.
Result<GaussNewton2> gaussNewton2(const TwoResiduals& residuals, TwoNumbers start,
                                  const TwoBounds& bounds);

}  // namespace perilymph::analysis
