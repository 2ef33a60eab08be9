// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The clinical table: forces, depths and rates of insertions by hand in virtual patients, and an
// experiment with one array, beside what is published. Nothing is fitted to it.

#include <cstdint>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "perilymph/analysis/ContactPositions.h"
#include "perilymph/analysis/FullInsertion.h"
#include "perilymph/analysis/InParallel.h"
#include "perilymph/foundation/Result.h"
#include "perilymph/foundation/Units.h"
#include "perilymph/haptics/InsertionEnd.h"

namespace perilymph::analysis {

/// One insertion by hand. It counts however it ended.
struct ClinicalInsertion {
  std::string array;
  std::uint64_t seed = 0, patient = 0;
  haptics::InsertionEnd end = haptics::InsertionEnd::refused;
  std::string reason;  ///< A message if the engine stopped or refused it.
  Length depth;        ///< At the end, past the opening.
  Angle apical;        ///< Angle of the most apical contact from the round window.
  Force peak;          ///< Maximum axial force on the hand.
  /// Mean axial force on the hand over the last HandDistribution::restMean before it stops.
  Force endForce;
  /// The same before it has rested for 1 s and for 10 s; absent if it did not rest so long, and from
  /// files of versions whose endForce was that after 2 s.
  std::optional<Force> forceAfter1s, forceAfter10s;
  Force partition;              ///< Maximum force on the cochlear partition, within one contact.
  bool isRuptured = false;      ///< The partition ruptured, at its drawn strength.
  bool isTranslocated = false;  ///< A part of the array is above the partition at the end.
  Angle ruptureAngle;           ///< Place of the first rupture; 0 without one.
  std::vector<ContactPosition> contacts;  ///< At the end, from the tip.
  std::vector<DepthForce> profile;        ///< Force at multiples of a spacing, first passage.
};

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
  int patients = 12;                ///< For each seed.
  std::string friction = "tissue";  ///< A shipped preset or a file, for the insertions by hand.
  unsigned jobs = 0;
};

struct ClinicalResult {
  std::vector<ClinicalInsertion> insertions;  ///< By seed, patient and array.
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
                                     const RunProgress& progress = {},
                                     const std::stop_token& stop = {});

/// The rows of insertions by hand; separate, so that they can be checked with known insertions.
Result<std::vector<ClinicalRow>> clinicalRows(const std::vector<ClinicalInsertion>& insertions);

/// `quantity, published low and high, prediction, ...`, one row per ClinicalRow.
std::string clinicalRowsCsv(const std::vector<ClinicalRow>& rows);

/// `seed, patient, array, end, ...`, one row per insertion.
std::string clinicalInsertionsCsv(const std::vector<ClinicalInsertion>& insertions);

/// The rows, the counts of hits and misses, the hand's distributions with their sources.
Result<std::string> clinicalJson(const ClinicalRequest& request, const ClinicalResult& result);

}  // namespace perilymph::analysis
