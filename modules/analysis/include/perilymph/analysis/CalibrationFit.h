// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Fits two array parameters to two printed forces; all other results remain predictions.

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
  double costBefore = 0.0;  ///< Sum of squared deviations in SD of the experiment, before
                            ///< calibration.
  double cost = 0.0;        ///< The same after calibration.
};

/// Receives the number of trials done; returns false to stop.
using CalibrationProgress = std::function<bool(std::size_t trials)>;

/// Bounded least squares (damped Gauss-Newton) of mean curves of insertions that vary as in the
/// experiment. The uncertainty follows from the experiment's standard errors.
Result<CalibrationResult> fitCalibration(const CalibrationRequest& request,
                                         const CalibrationProgress& progress);

}  // namespace perilymph::analysis
