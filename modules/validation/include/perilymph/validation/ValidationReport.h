// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Output of a validation: verdicts, tables, numbers and three figures.

#include <string>
#include <utility>
#include <vector>

#include "perilymph/figures/Figure.h"
#include "perilymph/validation/CalibrationFit.h"
#include "perilymph/validation/Validation.h"

namespace perilymph::validation {

/// One expected value compared with the result.
struct Verdict {
  Sentence what;    ///< "force at 10.6 mm, peak"
  Sentence found;   ///< "91.2 mN"
  Sentence wanted;  ///< "88.0 ± 18.6 mN"
  bool isMet = false;
};

/// Verdicts on every printed value and feature of the experiment, met or not.
std::vector<Verdict> verdictsOf(const ValidationResult& result,
                                const analysis::Reference& experiment);

/// Published data that verdicts and figures compare with.
struct ValidationReferences {
  analysis::Reference experiment, simulator, difference;
};
/// The shipped references.
Result<ValidationReferences> validationReferences();

/// The default request: the shipped experiment and its variability. The number of insertions, the
/// seed and the jobs have their defaults.
Result<ValidationRequest> shippedValidation(const ValidationReferences& references);

/// All output of a validation: texts with their file names, figures with names without extension.
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

/// All numbers: request, features, anchors, contributions to the spread, verdicts.
std::string summaryJson(const ValidationRequest& request, const ValidationResult& result);

/// The printed values of the experiment and of the published simulator.
figures::Figure experimentFigure(const analysis::Reference& experiment,
                                 const analysis::Reference& publishedSimulator);
/// The simulation with mean, confidence interval and spread, and the experiment's printed values.
figures::Figure simulationFigure(const ValidationResult& result,
                                 const analysis::Reference& experiment);
/// The same for a calibration, with fitted and other values apart.
figures::Figure calibrationFigure(const CalibrationResult& calibration,
                                  const analysis::Reference& experiment);
/// Simulator minus experiment at the printed values, and that of the published simulator.
figures::Figure differenceFigure(const ValidationResult& result,
                                 const analysis::Reference& publishedDifference);

}  // namespace perilymph::validation
