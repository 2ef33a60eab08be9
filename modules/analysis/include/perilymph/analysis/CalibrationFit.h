#pragma once

// Fits two numbers about the array to two printed forces; everything else stays a prediction.

#include "perilymph/analysis/Validation.h"
#include "perilymph/session/Calibration.h"

namespace perilymph::analysis {

/// What is asked of a calibration.
struct CalibrationRequest {
  session::Scenario scenario;  ///< With the array as its file says.
  Variability variability;
  Reference experiment;  ///< Its features "peak" and "maximum" are fitted, nothing else is.
  int runs = 24;         ///< Insertions behind each mean curve; the same ones for every trial.
  std::uint64_t seed = 1;
  unsigned jobs = 0;
};

struct CalibrationResult {
  session::Calibration calibration;
  int trials = 0;           ///< Mean curves that were computed.
  ValidationResult fitted;  ///< The last of them.
  double costBefore = 0.0;  ///< Sum of squared deviations in SD of the experiment, uncalibrated.
  double cost = 0.0;        ///< The same now.
};

/// Told how many trials are done; false stops.
using CalibrationProgress = std::function<bool(std::size_t trials)>;

/// Least squares within physical bounds (Gauss and Newton, damped), over mean curves of insertions
/// that vary as the experiment's did. The experiment's standard errors give the uncertainty.
Result<CalibrationResult> fitCalibration(const CalibrationRequest& request,
                                         const CalibrationProgress& progress);

/// The two numbers that minimize the squares of two residuals within bounds. For tests and for
/// fitCalibration().
struct TwoNumbers {
  double a = 0.0, b = 0.0;
};
struct TwoBounds {
  TwoNumbers low, high;
  TwoNumbers step;  ///< For differences; also the scale on which they matter.
  int raster = 1;   ///< So many even places of each number are tried first; the best one begins.
};
struct GaussNewton2 {
  TwoNumbers at;
  TwoNumbers residual;
  /// Standard errors for residuals of unit variance; 0 where a bound holds the number.
  TwoNumbers standardDeviation;
  int trials = 0;
};
using TwoResiduals = std::function<Result<TwoNumbers>(const TwoNumbers&)>;
Result<GaussNewton2> gaussNewton2(const TwoResiduals& residuals, TwoNumbers start,
                                  const TwoBounds& bounds);

}  // namespace perilymph::analysis
