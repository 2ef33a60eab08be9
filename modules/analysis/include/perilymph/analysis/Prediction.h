#pragma once

// What arrays do in cochleae that nothing was fitted to: how far around they come, and with what
// force, beside what clinics report.

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "perilymph/analysis/Reference.h"
#include "perilymph/foundation/Result.h"
#include "perilymph/foundation/Units.h"

namespace perilymph::analysis {

/// Angular insertion depths that clinics report for an array.
struct ClinicalAngle {
  std::string array;  ///< Its file's name.
  Angle median, low, high;
  std::string source;
};

/// The shipped ones: resources/clinical/insertion-angles.toml.
Result<std::vector<ClinicalAngle>> clinicalAngles();

/// What is asked of a prediction.
struct PredictionRequest {
  std::vector<std::string> arrays;        ///< Shipped names or files.
  std::string scenario = "mean-contour";  ///< Everything but array, depth and patient.
  Length startInside =
      millimeters(1);  ///< Start depth of the tip; it goes in to the array's full depth.
  int patients = 50;   ///< Virtual ones; the mean cochlea comes first.
  std::uint64_t seed = 1;
  unsigned jobs = 0;
};

/// One array in one cochlea.
struct PredictedInsertion {
  std::string array;    ///< As asked.
  std::string patient;  ///< "mean" or "sample 17".
  Angle apical;         ///< Angle of the most apical contact from the round window.
  Length depth;         ///< Past the opening at the end.
  Force end, peak;      ///< Axial, on the hand.
  /// A sentence where the insertion could not be carried out; nothing else holds then.
  std::string error;
};

/// One array in all cochleae, beside what clinics report.
struct ArraySummary {
  std::string array;
  std::optional<PredictedInsertion> mean;      ///< In the mean cochlea.
  int patients = 0;                            ///< In which it was carried out.
  Angle median, lowerQuartile, upperQuartile;  ///< Angles over all patients.
  Force medianEnd, medianPeak;                 ///< Forces over all patients.
  std::optional<ClinicalAngle> clinical;
  bool hitsAngle = false;  ///< The patients' median lies within the clinical range.
};

struct PredictionResult {
  std::vector<PredictedInsertion> insertions;  ///< Array by array, the mean cochlea first.
  std::vector<ArraySummary> arrays;
};

/// Runs every array in the mean cochlea and in virtual patients. The same request gives the same
/// bits whatever `jobs` is. `progress` is told how many insertions of how many are done; false
/// stops.
Result<PredictionResult> predict(const PredictionRequest& request,
                                 const std::function<bool(std::size_t, std::size_t)>& progress);

/// `array, patient, apical_deg, depth_mm, end_N, peak_N, error`, a row an insertion.
std::string predictionCsv(const PredictionResult& result);

/// The same with summaries, references and verdicts.
std::string predictionJson(const PredictionRequest& request, const PredictionResult& result,
                           const Reference& inVivo);

/// A quantile of values by straight lines between the ordered ones.
double quantile(std::vector<double> values, double fraction);

}  // namespace perilymph::analysis
