// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Rating of an insertion by several criteria, each with its value, range and source. It says
// nothing about trauma.

#include <optional>
#include <string>
#include <vector>

#include "perilymph/analysis/Comparison.h"
#include "perilymph/analysis/Reference.h"

namespace perilymph::analysis {

/// One criterion.
struct ScoreCriterion {
  Sentence name;          ///< "speed"
  Sentence found;         ///< "97 % of the way in at 0.1 to 2.0 mm/s"
  Sentence band;          ///< Values for full and for half of the points.
  Sentence source;        ///< Source of the range.
  double fraction = 0.0;  ///< Fraction of the maximum points: 0 to 1.
};

/// The total is 100 times the product of three factors: the fraction of the insertion that was done, the
/// fraction for the peak force, and the geometric mean of those for speed, reversals and smoothness (a choice,
/// low). So a high force, an early end or a poor motion is not made good by the others. With the reversals and
/// the rest of published hands and the middle of the peaks in patients it is 31. It is never shown
/// without its criteria.
struct InsertionScore {
  std::vector<ScoreCriterion> criteria;
  double total = 0.0;  ///< 0 to 100.

  /// "78 of 100: insertion 100 %, speed 100 %, reversals 95 %, peak force 37 %, smoothness 80 %".
  std::string sentence() const;
};

/// Definition of the total, for tables that hold scores: 1 summed points that ended at a threshold, 2 took
/// the mean of the criteria of technique, 3 is the product, 4 counts a withdrawal as one reversal.
inline constexpr int scoreDefinition = 4;

/// Rates speed, reversals, peak force and stops of an insertion up to the maximum depth, and how much of the
/// travel that its scenario sets was done. Reversals, force and stops count by h / (h + x) with the value x
/// and its half h, speed by Motion::wayBySpeed, so that no criterion saturates at a poor value. The force is
/// that with no marker rib at the opening.
///
/// @param peakBand  Peak forces measured in patients: half at their middle.
InsertionScore scoreOf(const ComparedInsertion& insertion, const PrintedRange& peakBand);

/// The same with the shipped range of peak forces in patients.
Result<InsertionScore> scoreOf(const ComparedInsertion& insertion);

}  // namespace perilymph::analysis
