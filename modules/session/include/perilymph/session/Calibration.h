// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Two array parameters that no data sheet gives, fitted to an experiment and stored with their
// uncertainty. They scale the array's own data; no force law is changed.

#include <filesystem>
#include <string>
#include <vector>

#include "perilymph/electrode/ArrayDesign.h"
#include "perilymph/foundation/Result.h"

namespace perilymph::session {

/// One fitted parameter.
struct FittedValue {
  double value = 0.0;
  double standardDeviation = 0.0;  ///< Standard error of the fit; 0 if the value is at a bound.
  double low = 0.0, high = 0.0;    ///< Physical bounds.
};

/// A printed force used by the fit, and the fitted value.
struct FittedForce {
  double travel = 0.0;  ///< [m]
  double wanted = 0.0;  ///< [N]
  double found = 0.0;   ///< [N]
};

struct Calibration {
  std::string label;
  std::string array;  ///< Name of the array.
  std::string source;
  FittedValue stiffnessScale{1.0, 0.0, 1.0,
                             1.0};  ///< Factor on every bending stiffness of array and stylet.
  /// Fraction of the free curvature that remains with the stylet in.
  FittedValue residualCurvature;
  std::vector<FittedForce> forces;
};

/// The initial values, within physical bounds for an array: a platinum stylet of 0.10 to 0.15 mm
/// has 0.82 to 4.2e-6 N.m^2 (E pi d^4 / 64, E = 168 GPa), a carrier 0.2 to 3e-6 N.m^2 (moduli after
/// Kha et al. 2004); and the remaining curvature bends the whole array by at most 10 degrees, so
/// that it appears straight.
Calibration uncalibrated(const electrode::ArrayDesign& array);

/// The array with scaled stiffness and the given residual curvature.
electrode::ArrayDesign calibrated(electrode::ArrayDesign array, double stiffnessScale,
                                  double residualCurvature);

/// Reads a calibration from its TOML file.
Result<Calibration> loadCalibration(const std::filesystem::path& file);

/// The calibration as the text of its TOML file.
std::string calibrationText(const Calibration& calibration);

}  // namespace perilymph::session
