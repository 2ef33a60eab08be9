// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Predictions without fitting: angular insertion depths and forces of arrays in cochleae, compared
// with clinical reports.

#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "perilymph/analysis/Reference.h"
#include "perilymph/analysis/RunProgress.h"
#include "perilymph/foundation/Result.h"
#include "perilymph/foundation/Units.h"

namespace perilymph::validation {

/// What a published range is.
enum class PublishedSpread { interquartile, range, deviation, none };

/// Clinically reported angular insertion depths of an array at one center.
struct ClinicalAngle {
  std::string array;  ///< Name of its file.
  Angle median;       ///< Or the mean.
  Angle low, high;    ///< Both the median if only that is published.
  PublishedSpread spread = PublishedSpread::none;
  int patients = 0;
  /// Mean and standard deviation of the number of contacts inside; absent if not published.
  std::optional<double> contactsInside, contactsDeviation;
  std::string source;
};

/// The shipped data, resources/clinical/insertion-angles.toml; an array may have several centers.
Result<std::vector<ClinicalAngle>> clinicalAngles();

/// Input of a prediction.
struct PredictionRequest {
  std::vector<std::string> arrays;        ///< Shipped names or files.
  std::string scenario = "mean-contour";  ///< Defines everything but array, depth and patient.
  Length startInside =
      millimeters(1);  ///< Initial depth of the tip; inserted to the array's full depth.
  int patients = 50;   ///< Number of virtual patients; the mean cochlea comes first.
  std::uint64_t seed = 1;
  unsigned jobs = 0;
};

/// One array in one cochlea.
struct PredictedInsertion {
  std::string array;    ///< As in the request.
  std::string patient;  ///< "mean" or "sample 17".
  Angle apical;         ///< Angle of the most apical contact from the round window.
  Length depth;         ///< Final depth past the opening.
  Force end, peak;      ///< Axial, on the hand.
  /// A message if the insertion ended early; the other values are then those at its end, zero if it
  /// could not be prepared.
  std::string error;
};

/// One array in all cochleae, compared with clinical reports.
struct ArraySummary {
  std::string array;
  std::optional<PredictedInsertion> mean;      ///< In the mean cochlea.
  int patients = 0;                            ///< Number of patients, however it ended.
  int complete = 0;                            ///< Number of them with the array at full depth.
  Angle median, lowerQuartile, upperQuartile;  ///< Angles over all patients.
  Force medianEnd, medianPeak;                 ///< Forces over all patients.
  std::optional<ClinicalAngle> clinical;
  bool hitsAngle = false;  ///< The median is within the clinical range.
};

struct PredictionResult {
  std::vector<PredictedInsertion> insertions;  ///< By array, the mean cochlea first.
  std::vector<ArraySummary> arrays;
};

/// Runs every array in the mean cochlea and in virtual patients. The same request gives the same
/// bits for any `jobs`. `stop` ends the work early, with an error.
Result<PredictionResult> predict(const PredictionRequest& request,
                                 const analysis::RunProgress& progress = {},
                                 const std::stop_token& stop = {});

/// `array, patient, apical_deg, depth_mm, end_N, peak_N, error`, one row per insertion.
std::string predictionCsv(const PredictionResult& result);

/// The same with summaries, references and verdicts.
std::string predictionJson(const PredictionRequest& request, const PredictionResult& result,
                           const analysis::Reference& inVivo);

}  // namespace perilymph::validation
