// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// What selected insertions of a study say together: groups, their differences, and trends. The page
// Studies, its export and the report of a study take their numbers here.

#include <array>
#include <cstdint>
#include <optional>
#include <stop_token>
#include <string>
#include <utility>
#include <vector>

#include "perilymph/analysis/LinearTrend.h"
#include "perilymph/analysis/SampleStatistics.h"
#include "perilymph/study/StudyColumns.h"

namespace perilymph::study {

/// A quantity of the summary.
struct SummarizedQuantity {
  const char* key;     ///< As in StudyColumns, and in the file.
  const char* column;  ///< Beginning of its columns in tables: "angle".
  const char* unit;    ///< End of the same: "deg".
  const char* title;   ///< In a report: "angular insertion depth, deg".
  int decimals;        ///< In a report.
};
inline constexpr std::array<SummarizedQuantity, 5> summarizedQuantities{{
    {"angle_deg", "angle", "deg", "angular insertion depth, deg", 1},
    {"depth_mm", "depth", "mm", "insertion depth, mm", 1},
    {"peak_mN", "peak", "mN", "peak insertion force, mN", 1},
    {"coverage_percent", "coverage", "percent", "cochlear coverage, %", 1},
    {"partition_mN", "partition", "mN", "peak force on the cochlear partition, mN", 2},
}};
/// One value for each of them.
template <class Value>
using OfEachQuantity = std::array<Value, summarizedQuantities.size()>;

/// Which insertions of a group a statistic is of.
enum class StudySelection : std::uint8_t {
  ran,       ///< All that ran, the stopped ones with what they reached; none that was not prepared.
  complete,  ///< Those that reached their full depth.
};
inline constexpr std::array studySelections{StudySelection::ran, StudySelection::complete};
/// "all that ran", "complete": the name in tables and reports.
const char* nameOf(StudySelection selection);
/// Whether an insertion belongs to a selection.
bool isIn(StudySelection selection, const StudyResult& result);
/// One value for each selection.
template <class Value>
struct OfEachSelection {
  Value ran, complete;

  Value& operator[](StudySelection selection)
  {
    return selection == StudySelection::ran ? ran : complete;
  }
  const Value& operator[](StudySelection selection) const
  {
    return selection == StudySelection::ran ? ran : complete;
  }
};

/// Statistics of the selected insertions of a group.
struct StudySample {
  std::size_t count = 0;
  /// Median, lower and upper quartile.
  OfEachQuantity<std::optional<analysis::Estimate>> quartiles;
  OfEachQuantity<std::optional<analysis::SampleStatistics>> means;
  std::optional<analysis::LinearTrend> trend;  ///< Vertical over horizontal quantity.
};

/// Insertions with one value of a setting.
struct StudyGroup {
  std::string level;                ///< The value; empty of all insertions together.
  std::vector<std::uint32_t> rows;  ///< Ascending.
  analysis::Estimate rate;          ///< Part of them that is complete, with Wilson's interval.
  OfEachSelection<StudySample> samples;

  std::size_t complete() const { return samples.complete.count; }
  std::size_t stopped() const { return samples.ran.count - samples.complete.count; }
  std::size_t notPrepared() const { return rows.size() - samples.ran.count; }
};

/// The difference of the means of two groups, first minus other.
struct StudyDifference {
  std::size_t group = 0, other = 0;  ///< Indices of the groups.
  StudySelection selection = StudySelection::ran;
  /// By pairs of insertions that share the cochlea and every other setting, the drawn ones too: the mean
  /// over cochleae of the mean of their pairs, with Student's interval, as pairs in one cochlea resemble
  /// each other; in a single cochlea over its pairs. Otherwise Welch's difference of the means.
  bool isPaired = false;
  std::size_t count = 0, otherCount = 0;  ///< Insertions of each; pairs if paired.
  std::size_t cochleae = 0;               ///< In which the pairs are; 0 without pairs.
  OfEachQuantity<std::optional<analysis::Estimate>> means;  ///< Empty without an interval.
};

/// What the groups are, and which quantities are plotted.
struct SummaryAxes {
  std::string x, y;   ///< Keys of quantities; unknown ones give no trend.
  std::string group;  ///< Key of a factor; any other text makes one group of all.
};

/// The summary of selected insertions.
struct StudySummary {
  SummaryAxes axes;
  std::vector<StudyGroup> groups;  ///< In the order of the factor's values; none is empty.
  /// Every pair of groups, of each selection. None of the groups of the endings: these are results, not
  /// settings.
  std::vector<StudyDifference> differences;
};

/// @param stop  Ends the work early; the summary is then incomplete.
StudySummary summaryOf(const StudyColumns& columns, const std::vector<std::uint32_t>& rows,
                       const SummaryAxes& axes, const std::stop_token& stop = {});

/// The tables of a summary as CSV files by name, with units in their headers: `points.csv` is as
/// insertions.csv of the study, for the selected insertions; then `groups.csv`, `differences.csv` and
/// `trends.csv`, with a row for each selection. Numbers have all their digits.
std::vector<std::pair<const char*, std::string>> tablesOf(const StudyColumns& columns,
                                                          const std::vector<std::uint32_t>& rows,
                                                          const StudySummary& summary);

/// Names of the files of tablesOf().
inline constexpr std::array summaryTables{"points.csv", "groups.csv", "differences.csv",
                                          "trends.csv"};

}  // namespace perilymph::study
