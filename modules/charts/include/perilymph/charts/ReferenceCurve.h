#pragma once

// The published experiment: the few values that were printed, and where.

#include <filesystem>
#include <string>
#include <vector>

#include "perilymph/foundation/Result.h"

namespace perilymph::charts {

/// One printed value of a measured force-depth curve.
struct ReferencePoint {
  double travel_mm = 0.0;
  double mean_N = 0.0;  ///< Axial force.
  double sd_N = 0.0;    ///< Standard deviation between insertions.
};

/// Printed values of one experiment. Nothing is known between them.
struct ReferenceCurve {
  std::string label;   ///< For the legend.
  std::string source;  ///< For the tooltip: who measured what, how.
  std::vector<ReferencePoint> points;
};

/// Reads the points of a reference (analysis/Reference.h says what its file holds); a file without
/// points is refused.
Result<ReferenceCurve> loadReference(const std::filesystem::path& file);

/// The printed values of Todd and Naghdy's experiment that ship with the program.
Result<ReferenceCurve> publishedExperiment();

}  // namespace perilymph::charts
