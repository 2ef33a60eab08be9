// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The clinical table: forces, depths and rates of insertions by hand in virtual patients, and an
// experiment with one array, beside what is published. Nothing is fitted to it.

#include <cstdint>
#include <stop_token>
#include <string>
#include <vector>

#include "perilymph/analysis/InParallel.h"
#include "perilymph/analysis/InsertionByHand.h"
#include "perilymph/foundation/Result.h"

namespace perilymph::validation {

/// How a row of the table is judged.
enum class RowVerdict {
  hit,
  miss,
  notJudged,  ///< No published value with a source that was read, or nothing to compare.
};

/// A row of the table: a published range and the prediction.
struct ClinicalRow {
  std::string quantity;          ///< "peak force", "angular depth of flex24".
  std::string unit;              ///< "mN", "deg", "%".
  double low = 0.0, high = 0.0;  ///< Published range; both 0 if none.
  double median = 0.0;           ///< Predicted; of a rate its value.
  double lowerQuartile = 0.0, upperQuartile = 0.0;
  double inside = 0.0;  ///< Fraction of the runs within the range.
  int runs = 0;
  RowVerdict verdict = RowVerdict::notJudged;
  bool isClinical = true;  ///< Insertions by hand; else an experiment with a phantom.
  std::string confidence;  ///< Confidence of the published range: "high", "medium" or "low".
  std::string source;
  std::string note;  ///< What the prediction rests on besides physics; empty if nothing.
};

/// Input of the table.
struct ClinicalRequest {
  std::vector<std::uint64_t> seeds = {1};
  int patients = 12;  ///< For each seed.
  /// A shipped preset or a file, for the insertions by hand.
  std::string friction = "estimate-from-pig-tissue";
  unsigned jobs = 0;
};

struct ClinicalResult {
  std::vector<analysis::ClinicalInsertion> insertions;  ///< By seed, patient and array.
  std::vector<ClinicalRow> rows;
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

/// `quantity, published low and high, prediction, ...`, one row per ClinicalRow.
std::string clinicalRowsCsv(const std::vector<ClinicalRow>& rows);

/// `seed, patient, array, end, ...`, one row per insertion.
std::string clinicalInsertionsCsv(const std::vector<analysis::ClinicalInsertion>& insertions);

/// The rows, the counts of hits and misses, the hand's distributions with their sources.
Result<std::string> clinicalJson(const ClinicalRequest& request, const ClinicalResult& result);

}  // namespace perilymph::validation
