// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Fits the scale of the array's stiffness to one printed force.

#include <stop_token>

#include "perilymph/foundation/InParallel.h"
#include "perilymph/session/Calibration.h"
#include "perilymph/validation/Validation.h"

namespace perilymph::validation {

/// Input of a calibration.
struct CalibrationRequest {
  session::InsertionParameters nominal;  ///< With the array as in its file.
  Variability variability;
  analysis::Reference experiment;  ///< Only its fittedFeature is fitted.
  int runs = 24;                   ///< Insertions per mean curve; the same ones in every trial.
  std::uint64_t seed = 1;
  unsigned jobs = 0;
};

struct CalibrationResult {
  session::Calibration calibration;
  int trials = 0;           ///< Number of mean curves computed.
  ValidationResult fitted;  ///< The last of them.
  double before = 0.0;      ///< Fitted force with the array as in its file [N].
};

/// Bounded secant method on the mean curve of insertions that vary as in the experiment. The
/// uncertainty follows from the experiment's standard error. `progress` receives the number of trials
/// done; `stop` ends the work early, with an error.
Result<CalibrationResult> fitCalibration(const CalibrationRequest& request,
                                         const PieceProgress& progress = {},
                                         const std::stop_token& stop = {});

}  // namespace perilymph::validation
