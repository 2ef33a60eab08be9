#pragma once

// Two numbers about an array that no data sheet gives, fitted to an experiment and kept with their
// uncertainty. They scale the array's own data; no law of force is touched.

#include <filesystem>
#include <string>
#include <vector>

#include "perilymph/electrode/ArrayDesign.h"
#include "perilymph/foundation/Result.h"

namespace perilymph::session {

/// One fitted number.
struct FittedValue {
  double value = 0.0;
  double standardDeviation = 0.0;  ///< Standard error of the fit; 0 where a bound holds the value.
  double low = 0.0, high = 0.0;    ///< What is physically possible.
};

/// A printed force that the fit used, and what came out.
struct FittedForce {
  double travel = 0.0;  ///< [m]
  double wanted = 0.0;  ///< [N]
  double found = 0.0;   ///< [N]
};

struct Calibration {
  std::string label;
  std::string array;  ///< Name of the array it was fitted for.
  std::string source;
  FittedValue stiffnessScale{1.0, 0.0, 1.0,
                             1.0};  ///< Factor on every bending stiffness of array and stylet.
  /// Share of the free curvature that is left with the stylet in.
  FittedValue residualCurvature;
  std::vector<FittedForce> forces;
};

/// The scale and the share that stay within physical bounds for an array: a platinum stylet of 0.10
/// to 0.15 mm has 0.82 to 4.2e-6 N.m^2 (E pi d^4 / 64, E = 168 GPa), a carrier 0.2 to 3e-6 N.m^2
/// (moduli after Kha et al. 2004); and the curvature that is left bends the whole array by at most
/// 10 degrees, or it would not pass for straight.
Calibration uncalibrated(const electrode::ArrayDesign& array);

/// The array with its stiffness scaled and its curvature set.
electrode::ArrayDesign calibrated(electrode::ArrayDesign array, double stiffnessScale,
                                  double residualCurvature);

/// Reads a calibration from its TOML file.
Result<Calibration> loadCalibration(const std::filesystem::path& file);

/// The calibration as that file.
std::string calibrationText(const Calibration& calibration);

}  // namespace perilymph::session
