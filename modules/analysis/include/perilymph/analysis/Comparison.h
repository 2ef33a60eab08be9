#pragma once

// Recorded insertions side by side.

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "perilymph/analysis/ForceProfile.h"
#include "perilymph/analysis/MotionCounter.h"
#include "perilymph/analysis/Reference.h"
#include "perilymph/figures/Figure.h"
#include "perilymph/foundation/Result.h"

namespace perilymph::analysis {

/// What one recording says.
struct ComparedInsertion {
  std::string name;  ///< Name of its file, without extension.
  std::string scenario;
  ForceProfile profile;
  int reversals = 0;  ///< From beginning to end.
  Motion motion;      ///< On the way to the deepest place.
};

/// Reads a recording whole. `goesOn` is asked now and then, and stops it by giving false.
Result<ComparedInsertion> readCompared(const std::filesystem::path& file,
                                       const std::function<bool()>& goesOn = {});

/// `name, scenario, peak_N, peak_travel_mm, peak_depth_mm, work_mJ, reversals, duration_s,
/// final_depth_mm, final_angle_deg`, a row a recording.
std::string comparisonCsv(const std::vector<ComparedInsertion>& insertions);

/// `travel_mm` and a column `<name>_N` for each recording, every 0.1 mm; empty where it has no
/// point.
std::string curvesCsv(const std::vector<ComparedInsertion>& insertions);

/// The curves over one axis, and the printed values of a reference where one is given.
figures::Figure comparisonFigure(const std::vector<ComparedInsertion>& insertions,
                                 const Reference* published = nullptr);

/// The force of a curve at a travel [m], straight lines between points; nothing outside it.
std::optional<double> forceAt(const std::vector<CurvePoint>& curve, double travel);

/// Insertions of one name get a number behind it: two recordings of one name would be one column.
void tellApart(std::vector<ComparedInsertion>& insertions);

}  // namespace perilymph::analysis
