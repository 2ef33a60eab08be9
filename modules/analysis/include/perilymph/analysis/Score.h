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
  Sentence band;          ///< Values for full and for zero points.
  Sentence source;        ///< Source of the range.
  double fraction = 0.0;  ///< Fraction of the maximum points: 0 to 1.
};

/// All criteria have equal weight. The total is never shown without them.
struct InsertionScore {
  std::vector<ScoreCriterion> criteria;
  double total = 0.0;  ///< 0 to 100.

  /// "78 of 100: speed 100 %, reversals 95 %, peak force 17 %, stops 100 %".
  std::string sentence() const;
};

/// Rates speed, reversals, peak force and stops of an insertion up to the maximum depth.
///
/// @param peakBand  Peak forces measured in patients: full points up to the minimum, zero from the
///                  maximum on, linear in between.
InsertionScore scoreOf(const ComparedInsertion& insertion, const PrintedRange& peakBand);

/// The same with the shipped range of peak forces in patients.
Result<InsertionScore> scoreOf(const ComparedInsertion& insertion);

}  // namespace perilymph::analysis
