#pragma once

// Forces that others measured or computed, as printed, with their sources. Nothing is known between
// printed values.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "perilymph/foundation/Result.h"

namespace perilymph::analysis {

/// One printed value of a force-depth curve.
struct PrintedForce {
  double travel = 0.0;             ///< [m]
  double mean = 0.0;               ///< Axial force [N].
  double standardDeviation = 0.0;  ///< Standard deviation between insertions [N].
  std::string feature;  ///< What it is on the curve: "peak", "dip", "maximum", "end"; or empty.
  std::string source;
};

/// A printed difference of two mean curves, simulator minus experiment.
struct PrintedDifference {
  double travel = 0.0;              ///< [m]
  double mean = 0.0;                ///< [N]
  std::optional<double> low, high;  ///< Bounds of the 95 % confidence interval [N].
  std::string source;
};

/// A force known as a range, or by mean and deviation, without a place on the axis of travel.
struct PrintedRange {
  std::string quantity;  ///< "end of insertion", "peak".
  double low = 0.0;      ///< [N]
  double high = 0.0;     ///< [N]
  std::string source;
};

/// What one publication says about forces.
struct Reference {
  std::string label;  ///< For legends.
  std::string kind;   ///< "experiment", "simulator", "in vivo" or "in vitro".
  std::string source;
  double insertions = 0.0;  ///< Behind each mean; 0 where unknown.
  std::vector<PrintedForce> points;
  std::vector<PrintedDifference> differences;
  std::vector<PrintedRange> ranges;

  /// The point of a feature, if there is one.
  const PrintedForce* find(const std::string& feature) const;
  /// The range of a quantity, if there is one.
  const PrintedRange* findRange(const std::string& quantity) const;
};

/// Reads a reference: keys `label, kind, source, insertions` and tables `[[point]]` (travel_mm,
/// mean_N, sd_N, feature, source), `[[difference]]` (travel_mm, mean_N, ci95_low_N, ci95_high_N,
/// source) and `[[range]]` (quantity, low_N, high_N, source). Points and differences are in the
/// order of travel.
Result<Reference> loadReference(const std::filesystem::path& file);

/// A shipped one by its name: "todd-naghdy-experiment".
Result<Reference> shippedReference(const std::string& name);

}  // namespace perilymph::analysis
