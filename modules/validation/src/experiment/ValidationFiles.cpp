// SPDX-License-Identifier: BSD-3-Clause

// Input and output files of a validation, the same for the command line and the window.

#include "perilymph/foundation/Resources.h"
#include "perilymph/validation/ValidationReport.h"

namespace perilymph::validation {

Result<ValidationReferences> validationReferences()
{
  ValidationReferences references;
  for (auto [name, place] : {std::pair{"todd-naghdy-experiment", &references.experiment},
                             std::pair{"todd-naghdy-simulator", &references.simulator},
                             std::pair{"todd-naghdy-difference", &references.difference}}) {
    auto loaded = analysis::shippedReference(name);
    if (!loaded) return loaded.error();
    *place = std::move(*loaded);
  }
  return references;
}

Result<ValidationRequest> shippedValidation(const ValidationReferences& references)
{
  ValidationRequest request;
  const auto file = findByName("variability", "resources/validation", "published-experiment");
  if (!file) return file.error();
  auto variability = loadVariability(*file);
  if (!variability) return variability.error();
  auto scenario = session::loadScenario(variability->scenario);
  if (!scenario) return scenario.error();
  request.variability = std::move(*variability);
  request.nominal = scenario->parameters();
  request.experiment = references.experiment;
  return request;
}

ValidationFiles validationFiles(const ValidationRequest& request, const ValidationResult& result,
                                const ValidationReferences& references)
{
  ValidationFiles files;
  files.texts = {{"profile.csv", profileCsv(result)},
                 {"difference.csv", differenceCsv(result)},
                 {"summary.json", summaryJson(request, result)}};
  files.figures = {
      {"experiment", draw(experimentFigure(references.experiment, references.simulator))},
      {"simulation", draw(simulationFigure(result, request.experiment))},
      {"difference", draw(differenceFigure(result, references.difference))}};
  return files;
}

}  // namespace perilymph::validation
