#include <cstdio>

#include "CallFiles.h"
#include "Commands.h"
#include "Interruption.h"
#include "OutputFile.h"
#include "OutputFolder.h"
#include "perilymph/analysis/ValidationReport.h"
#include "perilymph/foundation/Resources.h"

namespace perilymph::cli {

namespace {

void print(const char* what, const session::FittedValue& fitted)
{
  std::printf("%-19s %s ± %s, between %s and %s%s\n", what, fixed(fitted.value, 4).c_str(),
              fixed(fitted.deviation, 4).c_str(), fixed(fitted.low, 3).c_str(),
              fixed(fitted.high, 3).c_str(),
              fitted.deviation == 0.0 ? " (a bound holds it, or nothing depends on it)" : "");
}

void print(const analysis::CalibrationResult& result, const analysis::Reference& experiment)
{
  print("stiffness scale", result.calibration.stiffnessScale);
  print("residual curvature", result.calibration.residualCurvature);
  std::printf("sum of squares in standard deviations: %s before, %s now, %d trials\n",
              fixed(result.costBefore, 3).c_str(), fixed(result.cost, 3).c_str(), result.trials);
  for (const analysis::AnchorComparison& anchor : result.fitted.anchors) {
    bool isUsed = false;
    for (const session::FittedForce& force : result.calibration.forces)
      isUsed = isUsed || force.travel == anchor.experiment.travel;
    std::printf("%-10s %s mm: %s N (%s ± %s N)\n", isUsed ? "fitted" : "predicted",
                fixed(inMillimeters(meters(anchor.experiment.travel)), 1).c_str(),
                fixed(anchor.simulator.mean, 4).c_str(), fixed(anchor.experiment.mean, 4).c_str(),
                fixed(anchor.experiment.deviation, 4).c_str());
  }
  for (const auto& [name, feature, found] :
       {std::tuple{"peak", "peak", result.fitted.basalTurn.peak},
        std::tuple{"dip", "dip", result.fitted.basalTurn.dip}}) {
    const analysis::PrintedForce* printed = experiment.find(feature);
    if (found && printed)
      std::printf("%-10s place of the %s: %s mm (%s mm)\n", "predicted", name,
                  fixed(inMillimeters(meters(found->travel)), 1).c_str(),
                  fixed(inMillimeters(meters(printed->travel)), 1).c_str());
    else
      std::printf("%-10s place of the %s: there is none\n", "predicted", name);
  }
}

}  // namespace

Result<Done> calibrate(const CalibrateOptions& options, const CallFiles& files)
{
  const auto file = findByName("variability", "resources/validation", options.variability);
  if (!file) return file.error();
  auto variability = analysis::loadVariability(*file);
  if (!variability) return variability.error();
  // What is fitted anew begins with the array's own data.
  session::Overrides overrides = options.overrides;
  overrides.emplace_back("calibration", "");
  auto scenario = session::loadScenario(variability->scenario, overrides);
  if (!scenario) return scenario.error();
  if (const auto done = files.checkScenarioFiles(scenario->files); !done) return done.error();
  auto experiment = analysis::shippedReference("todd-naghdy-experiment");
  if (!experiment) return experiment.error();

  analysis::CalibrationRequest request;
  request.scenario = std::move(*scenario);
  request.variability = std::move(*variability);
  request.experiment = *experiment;
  request.runs = options.runs;
  request.seed = options.seed;
  request.jobs = options.jobs;
  watchForInterruption();
  std::printf("Fitting the array of %s to two printed forces.\n", request.scenario.name.c_str());
  std::fflush(stdout);
  // How many trials there will be is not known; about thirty.
  const auto result = analysis::fitCalibration(request, [](std::size_t trials) {
    return showProgress("trial", trials + 1, std::max<std::size_t>(trials + 2, 30));
  });
  if (isInterrupted()) return Error{"Interrupted; nothing was written."};
  if (!result) return result.error();

  FolderContent content;
  content.texts = {{"calibration.toml", session::calibrationText(result->calibration)},
                   {"profile.csv", analysis::profileCsv(result->fitted)},
                   {"difference.csv", analysis::differenceCsv(result->fitted)}};
  content.figures = {{"calibration", draw(analysis::calibrationFigure(*result, *experiment))}};
  if (const auto done = writeFolder(files, options.out, content); !done) return done.error();
  print(*result, *experiment);
  return Done{};
}

}  // namespace perilymph::cli
