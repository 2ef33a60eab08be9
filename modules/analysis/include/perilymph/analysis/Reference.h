// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Published forces, measured or computed, with their sources. They are not interpolated.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "perilymph/foundation/Result.h"
#include "perilymph/foundation/Units.h"

namespace perilymph::analysis {

/// One printed value of a force-travel curve.
struct PrintedForce {
  double travel = 0.0;             ///< [m]
  double mean = 0.0;               ///< Axial force [N].
  double standardDeviation = 0.0;  ///< Standard deviation between insertions [N].
  std::string feature;  ///< Its feature on the curve: "peak", "dip", "maximum", "end"; or empty.
  std::string source;
};

/// Bounds of a mean force that follow from other printed values.
struct PrintedInterval {
  double travel = 0.0;             ///< [m]
  double low = 0.0, high = 0.0;    ///< Axial force [N].
  double standardDeviation = 0.0;  ///< Standard deviation between insertions [N].
  std::string source;
};

/// A printed difference of two mean curves, simulator minus experiment.
struct PrintedDifference {
  double travel = 0.0;              ///< [m]
  double mean = 0.0;                ///< [N]
  std::optional<double> low, high;  ///< Bounds of the 95 % confidence interval [N].
  std::string source;
};

/// A force given as a range, or by mean and deviation, without a position on the travel axis.
struct PrintedRange {
  std::string quantity;  ///< "end of insertion", "peak".
  double low = 0.0;      ///< [N]
  double high = 0.0;     ///< [N]
  std::string source;
};

/// A single force: a median, a threshold.
struct PrintedValue {
  std::string quantity;  ///< "force felt, median".
  double value = 0.0;    ///< [N]
  std::string source;
};

/// Forces from one publication.
struct Reference {
  std::string label;  ///< Legend entry.
  std::string kind;   ///< "experiment", "simulator", "in vivo", "in vitro" or "perception".
  std::string source;
  double insertions = 0.0;  ///< Number of insertions per mean; 0 if unknown.
  std::vector<PrintedForce> points;
  std::vector<PrintedInterval> intervals;
  std::vector<PrintedDifference> differences;
  std::vector<PrintedRange> ranges;
  std::vector<PrintedValue> values;

  /// The point of a feature; null if absent.
  const PrintedForce* find(const std::string& feature) const;
  /// The range of a quantity; null if absent.
  const PrintedRange* findRange(const std::string& quantity) const;
  /// The value of a quantity; null if absent.
  const PrintedValue* findValue(const std::string& quantity) const;
};

/// Reads a reference: keys `label, kind, source, insertions` and tables `[[point]]` (travel_mm,
/// mean_N, sd_N, feature, source), `[[interval]]` (travel_mm, low_N, high_N, sd_N, source),
/// `[[difference]]` (travel_mm, mean_N, ci95_low_N, ci95_high_N,
/// source), `[[range]]` (quantity, low_N, high_N, source) and `[[value]]` (quantity, value_N,
/// source). Points, intervals and differences must each be in order of travel.
Result<Reference> loadReference(const std::filesystem::path& file);

/// A shipped reference by its name: "todd-naghdy-experiment".
Result<Reference> shippedReference(const std::string& name);

/// Median force that otologic surgeons detect (`resources/reference/surgeons.toml`): what forces
/// and differences of forces are compared with. Reads the file.
Result<Force> forceFeltBySurgeons();

/// Range of the peak insertion forces that were measured in patients (`resources/reference/in-vivo.toml`).
/// Reads the file.
Result<PrintedRange> peaksInPatients();

}  // namespace perilymph::analysis
