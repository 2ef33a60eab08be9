// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Comparison of recorded insertions.

#include <filesystem>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "perilymph/analysis/ForceProfile.h"
#include "perilymph/analysis/MotionCounter.h"
#include "perilymph/analysis/Reference.h"
#include "perilymph/figures/Figure.h"
#include "perilymph/foundation/Result.h"
#include "perilymph/session/RecordedInsertion.h"
#include "perilymph/session/SessionLibrary.h"

namespace perilymph::analysis {

/// Data of one recording.
struct ComparedInsertion {
  std::string name;  ///< Name for display, see session::displayNameOf().
  std::string scenario;
  session::ScenarioSubject subject;
  std::string startedUtc;  ///< "2010-05-17T09:30:00Z".
  ForceProfile profile;
  int reversals = 0;  ///< Over the whole insertion.
  Motion motion;      ///< Up to the maximum depth.
  /// The rupture of the cochlear partition, with the most of the array that was above it at a time;
  /// empty if the partition held.
  std::optional<haptics::Translocation> translocation;
  bool hasPublishedConditions = false;  ///< Comparable with the published measurements.
  session::RecordingCheck check;        ///< Whether the file is as it was recorded.
};

/// The name, with " (changed by hand)" if the file is not as it was recorded.
std::string labelOf(const ComparedInsertion& insertion);

/// Reads a whole recording and checks its seal. `stop` ends it early, with an error.
Result<ComparedInsertion> readCompared(const std::filesystem::path& file,
                                       const std::stop_token& stop = {});

/// `name, scenario, peak_N, peak_travel_mm, peak_depth_mm, work_mJ, reversals, duration_s,
/// final_depth_mm, final_angle_deg, rupture_angle_deg, rupture_N, above_mm`, one row per recording;
/// the last three are empty if the partition held.
std::string comparisonCsv(const std::vector<ComparedInsertion>& insertions);

/// `travel_mm` and a column `<name>_N` per recording, every 0.1 mm; empty where it has no point.
std::string curvesCsv(const std::vector<ComparedInsertion>& insertions);

/// Whether one of them has the conditions of the published measurements; else these are not drawn.
bool areComparableWithPublished(const std::vector<ComparedInsertion>& insertions);

/// The curves over a common axis, with the printed values of a reference if given.
figures::Figure comparisonFigure(const std::vector<ComparedInsertion>& insertions,
                                 const Reference* published = nullptr);

/// The force of a curve at a travel [m], linearly interpolated; empty outside its range.
std::optional<double> forceAt(const std::vector<CurvePoint>& curve, double travel);

/// Appends a number to insertions with equal names, which would share a column.
void tellApart(std::vector<ComparedInsertion>& insertions);

}  // namespace perilymph::analysis
