// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Printed values of the published experiment.

#include <filesystem>
#include <string>
#include <vector>

#include "perilymph/foundation/Result.h"

namespace perilymph::charts {

/// One printed value of a measured force-depth curve.
struct ReferencePoint {
  double travel_mm = 0.0;
  double mean_mN = 0.0;  ///< Axial force.
  double sd_mN = 0.0;    ///< Standard deviation between insertions.
};

/// Printed values of one experiment, not interpolated.
struct ReferenceCurve {
  std::string label;   ///< Legend entry.
  std::string source;  ///< Tooltip: authors and method.
  std::vector<ReferencePoint> points;
};

/// Reads the points of a reference (file format: analysis/Reference.h); a file without points is
/// refused.
Result<ReferenceCurve> loadReference(const std::filesystem::path& file);

/// The shipped printed values of Todd and Naghdy's experiment.
Result<ReferenceCurve> publishedExperiment();

}  // namespace perilymph::charts
