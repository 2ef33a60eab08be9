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

/// Four criteria of technique have equal weight; their mean counts by the fraction of the insertion that was
/// done, which is the fifth. So an insertion that failed early scores little however gentle it was. The total
/// is never shown without them.
struct InsertionScore {
  std::vector<ScoreCriterion> criteria;
  double total = 0.0;  ///< 0 to 100.

  /// "78 of 100: insertion 100 %, speed 100 %, reversals 95 %, peak force 37 %, smoothness 80 %".
  std::string sentence() const;
};

/// Rates speed, reversals, peak force and stops of an insertion up to the maximum depth, and how much of the
/// travel that its scenario sets was done. Points of
/// reversals, force and stops are h / (h + x) with the value x and its half h, so that a better value
/// gives more points wherever it lies. The force is that with no marker rib at the opening.
///
/// @param peakBand  Peak forces measured in patients: half of the points at their middle.
InsertionScore scoreOf(const ComparedInsertion& insertion, const PrintedRange& peakBand);

/// The same with the shipped range of peak forces in patients.
Result<InsertionScore> scoreOf(const ComparedInsertion& insertion);

}  // namespace perilymph::analysis
