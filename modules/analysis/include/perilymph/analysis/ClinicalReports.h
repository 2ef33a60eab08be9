// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// What clinics report of insertions with an array, to stand beside simulated values, and whether the
// program's own clinical table meets it.

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "perilymph/analysis/SampleStatistics.h"
#include "perilymph/foundation/Result.h"
#include "perilymph/foundation/Sentence.h"

namespace perilymph::analysis {

enum class ReportedQuantity : std::uint8_t {
  angle,           ///< Angle of the most apical contact [degrees].
  contactsInside,  ///< Number of contacts.
  complete,        ///< Complete insertions [%].
  translocation,   ///< Into the scala vestibuli [%].
  foldOver,        ///< Fold-over of the tip [%].
  peakForce,       ///< [mN]
  endForce         ///< [mN]
};
/// "angle", "complete", "peak_force".
const char* nameOf(ReportedQuantity quantity);

/// What the bounds of a report are.
enum class ReportedSpread : std::uint8_t {
  none,  ///< There are no bounds.
  quartiles,
  range,
  sd,         ///< Mean ± SD.
  interval95  ///< The 95 % interval of a count, by Wilson.
};

/// "quartiles", "sd", "interval95".
const char* nameOf(ReportedSpread spread);

/// One published value of one quantity.
struct ClinicalReport {
  std::vector<std::string> arrays;  ///< Names of files of arrays.
  ReportedQuantity quantity = ReportedQuantity::angle;
  std::string statistic;        ///< "median", "mean", "proportion", or "none": bounds alone.
  std::optional<double> value;  ///< In the unit of the quantity.
  ReportedSpread spread = ReportedSpread::none;
  double low = 0.0, high = 0.0;  ///< Bounds in that unit, unless there are none.
  std::optional<long> count;     ///< A proportion that is given as a count, out of n.
  long n = 0;                    ///< 0: not known from what was read.
  std::string nOf;      ///< "FLEX24 + FLEX28 + Standard": whose n it is; empty: the array's.
  std::string valueOf;  ///< "all arrays of all makers": whose value it is; empty: the array's.
  std::string definition, reference, source;
  std::string read;        ///< What of the source was read: "table", "abstract" or "quoted".
  std::string confidence;  ///< "high", "medium" or "low".
};

/// How the program's clinical table judges an array.
enum class ArrayVerdict : std::uint8_t {
  notTested,  ///< It has no row.
  hit,        ///< All rows are met.
  miss        ///< A row is missed.
};
/// "not_tested", "hit", "miss".
const char* nameOf(ArrayVerdict verdict);

/// Reports and verdicts of all arrays.
class ClinicalEvidence {
public:
  /// Reads two files, see resources/clinical/reports.toml and verdicts.toml. Refuses unknown
  /// quantities, bounds that do not enclose the value, counts above n, and unknown keys.
  static Result<ClinicalEvidence> read(const std::filesystem::path& reports,
                                       const std::filesystem::path& verdicts);
  /// The shipped files, read once.
  static const Result<ClinicalEvidence>& shipped();

  const std::vector<ClinicalReport>& reports() const { return reports_; }
  /// The first report of a quantity with an array; null if there is none.
  const ClinicalReport* find(const std::string& array, ReportedQuantity quantity) const;
  /// All of them, in the order of the file.
  std::vector<const ClinicalReport*> findAll(const std::string& array,
                                             ReportedQuantity quantity) const;
  ArrayVerdict verdictOf(const std::string& array) const;
  /// The rows that are missed for an array: "angular depth of flex24".
  std::vector<std::string> missedRows(const std::string& array) const;
  /// What the verdicts are from.
  const std::string& verdictSource() const { return verdictSource_; }

private:
  struct RowOfArray {
    std::string array, row;
    bool isHit = false;
  };
  std::vector<ClinicalReport> reports_;
  std::vector<RowOfArray> rows_;
  std::string verdictSource_;
};

/// "408 (quartiles 373 to 449)", "401 (SD 41)", "49 of 51", "44.8 to 102.4": the numbers of a
/// report with what the bounds are, without unit.
std::string numbersOf(const ClinicalReport& report);

}  // namespace perilymph::analysis
