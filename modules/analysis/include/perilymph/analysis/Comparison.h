#pragma once

// Recorded insertions side by side.

#include <filesystem>
#include <string>
#include <vector>

#include "perilymph/analysis/Figure.h"
#include "perilymph/analysis/ForceProfile.h"
#include "perilymph/foundation/Result.h"

namespace perilymph::analysis {

/// Counts how often a motion turns round. A way back of less than 0.1 mm is trembling, not a
/// reversal.
class ReversalCounter {
public:
  /// @param travel  [m]
  void add(double travel);
  int reversals() const { return reversals_; }

private:
  double extreme_ = 0.0;  ///< The farthest in the present direction [m].
  int direction_ = 0;     ///< +1 in, -1 out, 0 not known yet.
  bool hasBegun_ = false;
  int reversals_ = 0;
};

/// What one recording says.
struct ComparedInsertion {
  std::string name;  ///< Of its file, without ending.
  std::string scenario;
  ForceProfile profile;
  int reversals = 0;
};

/// Reads a recording whole.
Result<ComparedInsertion> readCompared(const std::filesystem::path& file);

/// `name, scenario, peak_N, peak_travel_mm, peak_depth_mm, work_mJ, reversals, duration_s,
/// final_depth_mm, final_angle_deg`, a row a recording.
std::string comparisonCsv(const std::vector<ComparedInsertion>& insertions);

/// `travel_mm` and a column `<name>_N` for each recording, every 0.1 mm; empty where it has no
/// point.
std::string curvesCsv(const std::vector<ComparedInsertion>& insertions);

/// The curves over one axis.
Figure comparisonFigure(const std::vector<ComparedInsertion>& insertions);

}  // namespace perilymph::analysis
