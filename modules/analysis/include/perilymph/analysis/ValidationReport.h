#pragma once

// What a validation leaves for people: verdicts, tables, numbers and three figures.

#include <string>
#include <utility>
#include <vector>

#include "perilymph/analysis/CalibrationFit.h"
#include "perilymph/analysis/Validation.h"
#include "perilymph/figures/Figure.h"

namespace perilymph::analysis {

/// One thing that was wanted and what came out.
struct Verdict {
  std::string what;    ///< "force at 10.6 mm, peak"
  std::string found;   ///< "0.0912 N"
  std::string wanted;  ///< "0.0880 ± 0.0186 N"
  bool isMet = false;
};

/// Every printed value and feature of the experiment, hits and misses alike.
std::vector<Verdict> verdictsOf(const ValidationResult& result, const Reference& experiment);

/// What others printed about the experiment: what verdicts and figures are held against.
struct ValidationReferences {
  Reference experiment, simulator, difference;
};
/// The shipped ones.
Result<ValidationReferences> validationReferences();

/// What a validation starts from by default: the shipped experiment and how it varied. The number
/// of insertions, the seed and the jobs stay as the request has them.
Result<ValidationRequest> shippedValidation(const ValidationReferences& references);

/// Everything a validation writes: names with ending and text, names without ending and figures.
struct ValidationFiles {
  std::vector<std::pair<std::string, std::string>> texts;
  std::vector<std::pair<std::string, figures::Drawing>> figures;
};
ValidationFiles validationFiles(const ValidationRequest& request, const ValidationResult& result,
                                const ValidationReferences& references);

/// `travel_mm, mean_N, sd_N, sem_N, ci95_low_N, ci95_high_N`, every 0.1 mm.
std::string profileCsv(const ValidationResult& result);

/// The same columns for simulator minus experiment, at the printed values.
std::string differenceCsv(const ValidationResult& result);

/// All numbers: what was run, features, anchors, shares of the spread, verdicts.
std::string summaryJson(const ValidationRequest& request, const ValidationResult& result);

/// The experiment as its printed values, beside it the published simulator's.
figures::Figure experimentFigure(const Reference& experiment, const Reference& publishedSimulator);
/// The simulation: mean, its confidence and its spread, beside it the experiment's printed values.
figures::Figure simulationFigure(const ValidationResult& result, const Reference& experiment);
/// The same for a calibration: which printed values it used, and which it predicts.
figures::Figure calibrationFigure(const CalibrationResult& calibration,
                                  const Reference& experiment);
/// Simulator minus experiment where the experiment is printed, beside it the published simulator's.
figures::Figure differenceFigure(const ValidationResult& result,
                                 const Reference& publishedDifference);

}  // namespace perilymph::analysis
