// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The results of a study as columns, to plot and filter many insertions at once.

#include <cstdint>
#include <filesystem>
#include <stop_token>
#include <string>
#include <vector>

#include "perilymph/foundation/Result.h"
#include "perilymph/study/StudyFile.h"

namespace perilymph::study {

/// A number of every insertion.
struct StudyQuantity {
  std::string
      key;  ///< As in the table: "peak_mN", the key of a setting, or a file's "friction_static".
  std::vector<double> values;  ///< One per insertion; NaN where it has none.
};

/// A setting with 2 to StudyColumns::maxLevels values, or how the insertions ended.
struct StudyFactor {
  std::string key;                   ///< "array", or "ending".
  std::vector<std::string> levels;   ///< Values, in the order of their first insertion.
  std::vector<std::uint16_t> level;  ///< One per insertion: index into `levels`.
  /// The values as figures and reports show them: arrays by their names, other files without their folders; as
  /// they are, where two would look the same.
  std::vector<std::string> shown;

  /// A value as it is shown.
  std::string shownOf(const std::string& value) const;
};

/// Which insertions are selected.
struct StudyFilter {
  /// One per factor and level; a factor without entries selects all.
  std::vector<std::vector<bool>> levels;
  double minA_mm = 0.0, maxA_mm = 1e9;  ///< Size of the cochlea: diameter A of the basal turn.
};

/// An insertion's value of a setting; empty if it has none.
std::string settingOf(const StudyResult& result, const std::string& key);

/// The numbers of many insertions. Immutable.
class StudyColumns {
public:
  /// A setting with more values is a quantity only, if they are numbers.
  static constexpr std::size_t maxLevels = 12;
  /// Maximum number of insertions: about half a gigabyte while they are read (choice, high).
  static constexpr std::size_t maxInsertions = 1'000'000;

  /// Reads a merged file or a shard. The error states what to do.
  ///
  /// @param max  More insertions are refused.
  static Result<StudyColumns> read(const std::filesystem::path& file, const std::stop_token& stop,
                                   std::size_t max = maxInsertions);
  /// @param results  At least one.
  StudyColumns(StudyFileFacts facts, std::vector<StudyResult> results);

  const StudyFileFacts& facts() const noexcept { return facts_; }
  std::size_t size() const noexcept { return results_.size(); }
  const std::vector<StudyQuantity>& quantities() const noexcept { return quantities_; }
  const std::vector<StudyFactor>& factors() const noexcept { return factors_; }
  /// The insertion in row `row`, without contacts and profile.
  const StudyResult& result(std::size_t row) const { return results_[row]; }
  /// The quantity with a key; null if there is none.
  const StudyQuantity* quantity(const std::string& key) const;
  /// The factor with a key; null if there is none.
  const StudyFactor* factor(const std::string& key) const;

  /// What the files say that settings name, by StudyFileValue::name, in alphabetical order.
  std::vector<std::string> fileColumns() const;
  /// The content under a name for an insertion; empty if it has none.
  std::string fileValueOf(const StudyResult& result, const std::string& name) const;

  /// Settings that are quantities but no factors: drawn from a range, or with too many values.
  std::vector<std::string> ranges() const;

  /// The rows that a filter selects, in order.
  std::vector<std::uint32_t> rows(const StudyFilter& filter) const;

private:
  void addQuantities();
  void addSettings();

  StudyFileFacts facts_;
  std::vector<StudyResult> results_;
  std::vector<StudyQuantity> quantities_;
  std::size_t settingsEnd_ = 0;  ///< End of those of insertions and settings; of files follow.
  std::vector<StudyFactor> factors_;
};

}  // namespace perilymph::study
