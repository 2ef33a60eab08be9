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

}  // namespace perilymph::analysis
