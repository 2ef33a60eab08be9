#pragma once

// How an insertion was done, criterion by criterion: each with its number, its band and where the
// band comes from. It says nothing about trauma.

#include <optional>
#include <string>
#include <vector>

#include "perilymph/analysis/Comparison.h"
#include "perilymph/analysis/Reference.h"

namespace perilymph::analysis {

/// One thing that was looked at.
struct ScoreCriterion {
  std::string name;       ///< "speed"
  std::string found;      ///< "97 % of the way in at 0.1 to 2.0 mm/s"
  std::string band;       ///< What gives all points, and what none.
  std::string source;     ///< Source of the band.
  double fraction = 0.0;  ///< Fraction of its points: 0 to 1.
};

/// The criteria weigh the same. The total is never shown without them.
struct InsertionScore {
  std::vector<ScoreCriterion> criteria;
  double total = 0.0;  ///< 0 to 100.

  /// "78 of 100: speed 100 %, reversals 95 %, peak force 17 %, stops 100 %".
  std::string sentence() const;
};

/// Speed, reversals, peak force and stops of an insertion on its way to the deepest place.
///
/// @param peakBand  Peak forces measured in patients: all points up to the least of them, none from
///                  the greatest on, evenly in between.
InsertionScore scoreOf(const ComparedInsertion& insertion, const PrintedRange& peakBand);

/// The same against the shipped range of peaks in patients.
Result<InsertionScore> scoreOf(const ComparedInsertion& insertion);

}  // namespace perilymph::analysis
