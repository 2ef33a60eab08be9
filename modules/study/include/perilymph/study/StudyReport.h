// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// What a merged study says: distributions, effects and figures.

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "perilymph/analysis/SampleStatistics.h"
#include "perilymph/figures/Figure.h"
#include "perilymph/foundation/Result.h"
#include "perilymph/study/StudyFile.h"

namespace perilymph::study {

using analysis::Estimate;

/// A quantity that the report is about.
enum class Outcome { angle, coverage, peakForce, partitionForce };
/// "angular insertion depth, deg".
std::string titleOf(Outcome outcome);

/// What changing a factor to a level does, or what two levels do together beyond their sum.
struct Effect {
  std::string name;  ///< "friction = tissue", or two of these.
  Estimate size;     ///< Difference from the mean over all combinations.
};

/// Rate of change with the size of the cochlea or with a value that was drawn from a range.
struct Slope {
  std::string name;  ///< "A_mm", or the key of the range.
  Estimate perUnit;
};

/// Results of a study, evaluated. A setting with 2 to 12 values is a factor; one with more is a
/// range.
class StudyEvaluation {
public:
  explicit StudyEvaluation(std::vector<StudyResult> results);

  /// The factors and their levels.
  const std::map<std::string, std::vector<std::string>>& factors() const { return factors_; }
  const std::vector<std::string>& ranges() const { return ranges_; }

  /// Effect of every level of every factor, within cochleae in which every insertion finished: the
  /// mean over cochleae of the level's mean minus that of the cochlea. The interval is that of this
  /// mean; empty for fewer than 3 such cochleae.
  std::vector<Effect> mainEffects(Outcome outcome) const;
  /// The same for pairs of levels of two factors, beyond the sum of their effects; the largest first.
  std::vector<Effect> interactions(Outcome outcome) const;
  /// Slope of the finished insertions within their combination of levels, by least squares.
  std::vector<Slope> slopes(Outcome outcome) const;

  const std::vector<StudyResult>& results() const { return results_; }
  /// The result's value of a setting; empty if it has none.
  static std::string settingOf(const StudyResult& result, const std::string& key);

private:
  std::vector<std::vector<const StudyResult*>> wholeCochleae() const;
  std::string combinationOf(const StudyResult& result) const;

  std::vector<StudyResult> results_;
  std::map<std::string, std::vector<std::string>> factors_;
  std::vector<std::string> ranges_;
};

/// A report: text (Markdown) and figures by name.
struct StudyReport {
  std::string text;
  std::vector<std::pair<std::string, figures::Figure>> figures;
};

/// The report of a merged study.
Result<StudyReport> reportOf(const StudyFile& file);

}  // namespace perilymph::study
