// SPDX-License-Identifier: BSD-3-Clause
#include "scenario/ScenarioCalibration.h"

#include "perilymph/foundation/Resources.h"
#include "perilymph/session/Calibration.h"

namespace perilymph::session {

Result<AskedCalibration> readCalibration(TomlReader& reader, ScenarioKeys& keys,
                                         ScenarioContent& scenario)
{
  AskedCalibration asked;
  scenario.calibrationName = keys.text("calibration", "");
  const bool needsFile =
      !scenario.calibrationName.empty() &&
      !(reader.has("stiffness_scale") && reader.has("residual_curvature_fraction"));
  if (needsFile) {
    const auto file = findByName("calibration", "resources/calibration", scenario.calibrationName);
    if (!file) return file.error();
    const auto calibration = loadCalibration(*file);
    if (!calibration) return calibration.error();
    asked.array = calibration->array;
    asked.stiffnessScale = calibration->stiffnessScale.value;
    asked.residualCurvature = calibration->residualCurvature.value;
  }
  // Half or twice the diameter of a wire or carrier changes the stiffness by a factor of sixteen; a
  // factor of ten exceeds all uncertainties here.
  asked.stiffnessScale = keys.number("stiffness_scale", {0.1, 10.0}, asked.stiffnessScale);
  if (asked.residualCurvature || reader.has("residual_curvature_fraction"))
    asked.residualCurvature = keys.number("residual_curvature_fraction", {0.0, 1.0},
                                          asked.residualCurvature.value_or(0.0));
  return asked;
}

Result<void> applyCalibration(const AskedCalibration& asked, ScenarioContent& scenario)
{
  if (!asked.array.empty() && asked.array != scenario.parameters.array.name)
    return Error{
        "The calibration %1 was fitted for the array %2, not for %3. Set calibration to \"\" or "
        "name one of this array.",
        scenario.calibrationName, asked.array, scenario.parameters.array.name};
  const double residual =
      asked.residualCurvature.value_or(scenario.parameters.array.stylet.residualCurvature);
  scenario.parameters.array =
      calibrated(std::move(scenario.parameters.array), asked.stiffnessScale, residual);
  return {};
}

}  // namespace perilymph::session
