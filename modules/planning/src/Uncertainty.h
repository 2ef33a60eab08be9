// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// What is uncertain about an insertion besides the measures of the cochlea and the surgeon's hand.

#include <filesystem>
#include <string>
#include <vector>

#include "perilymph/analysis/PackingRange.h"
#include "perilymph/electrode/ArrayDesign.h"
#include "perilymph/foundation/Result.h"
#include "perilymph/foundation/Units.h"

namespace perilymph::planning {

/// Standard deviations of array and approach, as data with sources.
struct Uncertainty {
  /// Source and confidence of the values of one table of the file.
  struct Provenance {
    std::string table, source, confidence;
  };

  /// Fraction of the bending stiffness, by the confidence that the array's file gives it: log-normal
  /// with mean 1.
  double highStiffness = 0.0, mediumStiffness = 0.0, lowStiffness = 0.0;
  Angle tiltDeviation, turnDeviation;  ///< The approach's, from the scenario's: normal.
  /// Limit of the approach's deviates: a larger one would have been corrected.
  double maxDeviates = 0.0;
  /// What varies along the scala: normal, with the covariance s^2 exp(-d^2 / 2 l^2) between angles d
  /// apart.
  struct Variation {
    double standardDeviation = 0.0;  ///< s
    Angle correlation;               ///< l
  };
  Variation section;  ///< Factor of the sections' width and height: log-normal with mean 1.
  Variation course;   ///< Height of the center line above the mean's course [m].
  Variation radius;   ///< Relative change of the outer wall's distance from the axis.
  /// Fraction of the mean shape's H where it was not measured: normal, within a limit of deviates.
  double heightDeviation = 0.0, maxHeightDeviates = 0.0;
  Length liningLow, liningHigh;         ///< Thickness: uniform in its logarithm.
  analysis::PackingRange packing;       ///< How tightly wires are packed; from a file of its own.
  Stiffness membraneLow, membraneHigh;  ///< Under a sample point: uniform in its logarithm.
  std::vector<Provenance> provenance;

  /// Standard deviation of an array's stiffness, as a fraction; beside a drawn c at most that of a
  /// medium confidence, because c is most of what is not known.
  double stiffnessOf(const electrode::ArrayDesign& array) const;
};

/// Reads the deviations but those of the wires from a TOML file.
Result<Uncertainty> loadUncertainty(const std::filesystem::path& file);
/// The shipped file without the wires: resources/planning/uncertainty.toml.
std::filesystem::path shippedUncertaintyFile();
Result<Uncertainty> shippedUncertainty();

}  // namespace perilymph::planning
