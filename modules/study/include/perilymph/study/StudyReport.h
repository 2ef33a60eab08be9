// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// What a merged study says: groups, differences, effects and figures.

#include <string>
#include <utility>
#include <vector>

#include "perilymph/figures/Figure.h"
#include "perilymph/foundation/Result.h"
#include "perilymph/study/StudySummary.h"

namespace perilymph::study {

using analysis::Estimate;

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

/// Effects of the factors of a study (StudyColumns::factors(), without the ending) and slopes over its
/// ranges, the settings that are quantities but no factors.
class StudyEvaluation {
public:
  /// @param columns  Outlive the evaluation.
  explicit StudyEvaluation(const StudyColumns& columns);

  const std::vector<const StudyFactor*>& factors() const { return factors_; }
  const std::vector<std::string>& ranges() const { return ranges_; }

  /// Effect of every level of every factor on a quantity, within cochleae of which every insertion is
  /// selected: the mean over cochleae of the level's mean minus that of the cochlea, with Student's
  /// interval; empty for fewer than 3 such cochleae.
  ///
  /// @param quantity  A key of StudyColumns.
  std::vector<Effect> mainEffects(const std::string& quantity, StudySelection selection) const;
  /// The same for pairs of levels of two factors, beyond the sum of their effects; the largest first.
  std::vector<Effect> interactions(const std::string& quantity, StudySelection selection) const;
  /// Slope of the selected insertions within their combination of levels, by least squares, with
  /// Student's interval.
  std::vector<Slope> slopes(const std::string& quantity, StudySelection selection) const;

private:
  using Rows = std::vector<std::uint32_t>;
  std::vector<Rows> wholeCochleae(StudySelection selection) const;

  const StudyColumns* columns_;
  std::vector<const StudyFactor*> factors_;
  std::vector<std::string> ranges_;
};

/// A report: text (Markdown) and figures by name.
struct StudyReport {
  std::string text;
  std::vector<std::pair<std::string, figures::Figure>> figures;
};

/// The report of a merged study, of each selection.
StudyReport reportOf(const StudyColumns& columns);

}  // namespace perilymph::study
