// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The clinical table: forces, depths and rates of insertions by hand in virtual patients, and an
// experiment with one array, beside what is published. Nothing is fitted to it.

#include <cstdint>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "perilymph/analysis/InsertionByHand.h"
#include "perilymph/analysis/RunProgress.h"
#include "perilymph/foundation/Result.h"

namespace perilymph::validation {

/// How a row of the table is judged.
enum class RowVerdict {
  hit,
  miss,
  notJudged,  ///< No published value with a source that was read, or nothing to compare.
};

/// A companion of an angle: what should be met too if the angle is met for the right reason.
struct ClinicalCompanion {
  double found = 0.0;      ///< Predicted mean or median.
  double published = 0.0;  ///< NaN if not published.
  int runs = 0;            ///< Insertions that it rests on.
  bool isMet = true;       ///< Also if nothing is published.
};

/// A row of the table: what is published, pooled over centers, and the prediction.
struct ClinicalRow {
  std::string quantity;          ///< "peak force", "angular depth of flex24".
  std::string unit;              ///< "mN", "deg", "%".
  double low = 0.0, high = 0.0;  ///< Published range, of a rate its 95 %; both 0 if none.
  double published = 0.0;        ///< Published median over centers, of a rate its value.
  int patients = 0;              ///< That it rests on; 0 if unknown.
  double median = 0.0;           ///< Predicted; of a rate its value.
  double lowerQuartile = 0.0, upperQuartile = 0.0;
  double inside = 0.0;  ///< Fraction of the runs within the range.
  int runs = 0;
  /// Half width of the differences predicted - published that are a hit; 0 without a verdict.
  double tolerance = 0.0;
  /// Probability that the rule finds an error of 100 degrees, or of 20 percentage points.
  double power = 0.0;
  RowVerdict verdict = RowVerdict::notJudged;  ///< Verdict on the median or the rate; counted.
  RowVerdict atMedianFriction = RowVerdict::notJudged;  ///< The same if the friction were known.
  RowVerdict spread = RowVerdict::notJudged;            ///< Verdict on the interquartile range.
  double spreadFactor = 0.0;     ///< Predicted over published interquartile range.
  double spreadTolerance = 0.0;  ///< Factor, either way, that is a hit.
  std::optional<ClinicalCompanion> contactsInside;  ///< Mean number.
  std::optional<ClinicalCompanion> angleAtLength;   ///< Median angle at the published length.
  double depth_mm = 0.0;                            ///< Median insertion depth.
  bool isClinical = true;  ///< Insertions by hand; else an experiment with a phantom.
  std::string confidence;  ///< Confidence of the published range: "high", "medium" or "low".
  std::string source;
  std::string note;  ///< What the prediction rests on besides physics; empty if nothing.
};

/// What a perfect model would reach: published samples are drawn from the simulated ones, with one
/// friction for all rows and with differences between centers, and judged by the same rule.
struct PerfectModel {
  int rows = 0;                 ///< Rows with a verdict.
  double expected = 0.0;        ///< Mean number of hits.
  double all = 0.0;             ///< Probability that every row is a hit.
  std::vector<double> exactly;  ///< Probability of each number of hits.
};

/// Input of the table.
struct ClinicalRequest {
  std::vector<std::string> arrays;  ///< Shipped names; empty: clinicalArrays, and the phantom.
  std::vector<std::uint64_t> seeds = {1};
  int patients = 12;  ///< For each seed.
  /// A shipped preset or a file, for the insertions by hand.
  std::string friction = "estimate-from-pig-tissue";
  unsigned jobs = 0;
};

struct ClinicalResult {
  std::vector<analysis::ClinicalInsertion> insertions;  ///< By seed, patient and array.
  std::vector<ClinicalRow> rows;
  PerfectModel perfect;
};

/// Arrays of the table: those with published angular depths.
inline constexpr const char* clinicalArrays[] = {"flex24", "flex28", "medel-standard",
                                                 "hifocus-slimj", "flexsoft"};

/// Number of insertions that a request runs.
std::size_t insertionsOf(const ClinicalRequest& request);

/// Computes the table. The same request gives the same bits for any `jobs`. `stop` ends the
/// work early, with an error.
Result<ClinicalResult> predictClinic(const ClinicalRequest& request,
                                     const analysis::RunProgress& progress = {},
                                     const std::stop_token& stop = {});

/// The rows of insertions by hand; separate, so that they can be checked with known insertions.
Result<std::vector<ClinicalRow>> clinicalRows(
    const std::vector<analysis::ClinicalInsertion>& insertions);

/// What a perfect model would reach with as many insertions; needs at least two of each array.
Result<PerfectModel> perfectModel(const std::vector<analysis::ClinicalInsertion>& insertions);

/// `quantity, published low and high, prediction, ...`, one row per ClinicalRow.
std::string clinicalRowsCsv(const std::vector<ClinicalRow>& rows);

/// `seed, patient, array, end, ...`, one row per insertion.
std::string clinicalInsertionsCsv(const std::vector<analysis::ClinicalInsertion>& insertions);

/// The rows, the counts of hits and misses, the hand's distributions with their sources.
Result<std::string> clinicalJson(const ClinicalRequest& request, const ClinicalResult& result);

}  // namespace perilymph::validation
