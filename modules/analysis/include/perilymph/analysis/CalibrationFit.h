// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Fits two array parameters to two printed forces, and says how well both can be met.

#include "perilymph/analysis/Validation.h"
#include "perilymph/session/Calibration.h"

namespace perilymph::analysis {

/// Input of a calibration.
struct CalibrationRequest {
  session::InsertionParameters nominal;  ///< With the array as in its file.
  Variability variability;
  Reference experiment;  ///< Only its features "peak" and "maximum" are fitted.
  int runs = 24;         ///< Insertions per mean curve; the same ones in every trial.
  std::uint64_t seed = 1;
  unsigned jobs = 0;
};

struct CalibrationResult {
  session::Calibration calibration;
  int trials = 0;           ///< Number of mean curves computed.
  ValidationResult fitted;  ///< The last of them.
  /// Sum of squared differences at the fitted forces, in standard errors of the experiment's means:
  /// before and after the fit.
  double chiSquareBefore = 0.0, chiSquare = 0.0;
  /// Number of fitted forces minus that of parameters which the forces determine; a parameter at a
  /// bound does not count.
  int degreesOfFreedom = 0;
  /// Probability of a chi-square at least this large if the model were right and only the means
  /// uncertain; 1 without a degree of freedom.
  double pValue = 1.0;
};

/// Probability that a chi-square variable of 0, 1 or 2 degrees of freedom is at least `chiSquare`.
double chiSquareTail(double chiSquare, int degreesOfFreedom);

/// Receives the number of trials done; returns false to stop.
using CalibrationProgress = std::function<bool(std::size_t trials)>;

/// Bounded least squares (damped Gauss-Newton) of mean curves of insertions that vary as in the
/// experiment. The uncertainty follows from the experiment's standard errors.
Result<CalibrationResult> fitCalibration(const CalibrationRequest& request,
                                         const CalibrationProgress& progress);

}  // namespace perilymph::analysis
