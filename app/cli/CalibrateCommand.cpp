// SPDX-License-Identifier: BSD-3-Clause

#include "CommandFiles.h"

#include <stop_token>
#include "Commands.h"
#include "Interruption.h"
#include "OutputFolder.h"
#include "Terminal.h"
#include "perilymph/foundation/Resources.h"
#include "perilymph/validation/ValidationReport.h"

namespace perilymph::cli {

namespace {

/// A force [N] in millinewtons.
std::string forceText(double force) { return fixed(inMillinewtons(newtons(force)), 1); }

void printValue(const char* what, const session::FittedValue& fitted)
{
  print("{:19} {} ± {}, between {} and {}{}\n", what, fixed(fitted.value, 4),
        fixed(fitted.standardDeviation, 4), fixed(fitted.low, 3), fixed(fitted.high, 3),
        fitted.standardDeviation == 0.0 ? " (at a bound, or without effect)" : "");
}

void printSummary(const validation::CalibrationResult& result,
                  const analysis::Reference& experiment)
{
  printValue("stiffness scale", result.calibration.stiffnessScale);
  print("fitted force {} mN before, {} trials\n", forceText(result.before), result.trials);
  const validation::Agreement predicted = validation::agreementOf(result.fitted);
  print(
      "predicted forces: largest difference {} mN, chi-square {}, degrees of freedom: {}, p = {}\n",
      forceText(predicted.largest), fixed(predicted.chiSquare, 1), predicted.degreesOfFreedom,
      fixed(predicted.pValue, 4));
  for (const validation::AnchorComparison& anchor : result.fitted.anchors) {
    bool isUsed = false;
    for (const session::FittedForce& force : result.calibration.forces)
      isUsed = isUsed || force.travel == anchor.experiment.travel;
    print("{:10} {} mm: {} mN ({} ± {} mN)\n", isUsed ? "fitted" : "not fitted",
          fixed(inMillimeters(meters(anchor.experiment.travel)), 1),
          forceText(anchor.simulator.mean), forceText(anchor.experiment.mean),
          forceText(anchor.experiment.standardDeviation));
  }
  for (const validation::IntervalComparison& interval : result.fitted.intervals)
    print("{:10} {} mm: {} mN ({} to {} mN)\n", "not fitted",
          fixed(inMillimeters(meters(interval.experiment.travel)), 1),
          forceText(interval.simulator.mean), forceText(interval.experiment.low),
          forceText(interval.experiment.high));
  for (const auto& [name, feature, found] :
       {std::tuple{"peak", "peak", result.fitted.basalTurn.peak},
        std::tuple{"dip", "dip", result.fitted.basalTurn.dip}}) {
    const analysis::PrintedForce* printed = experiment.find(feature);
    if (found && printed)
      print("{:10} position of the {}: {} mm ({} mm)\n", "not fitted", name,
            fixed(inMillimeters(meters(found->travel)), 1),
            fixed(inMillimeters(meters(printed->travel)), 1));
    else
      print("{:10} position of the {}: none\n", "not fitted", name);
  }
}

}  // namespace

Result<void> calibrate(const CalibrateOptions& options, const CommandFiles& files)
{
  const auto file = findByName("variability", "resources/validation", options.variability);
  if (!file) return file.error();
  auto variability = validation::loadVariability(*file);
  if (!variability) return variability.error();
  // A new fit starts from the array's own data.
  session::Overrides overrides = options.overrides;
  overrides.emplace_back("calibration", "");
  auto scenario = session::loadScenario(variability->scenario, overrides);
  if (!scenario) return scenario.error();
  if (const auto done = files.checkScenarioFiles(scenario->files()); !done) return done.error();
  auto experiment = analysis::shippedReference("todd-naghdy-experiment");
  if (!experiment) return experiment.error();

  validation::CalibrationRequest request;
  request.nominal = scenario->parameters();
  request.variability = std::move(*variability);
  request.experiment = *experiment;
  request.runs = options.runs;
  request.seed = options.seed;
  request.jobs = options.jobs;
  const std::stop_token stop = watchForInterruption();
  print("Calibrating the array of {} against one published force.\n", request.nominal.name);
  flushOutput();
  // The number of trials is not known in advance; about four.
  const auto result = validation::fitCalibration(
      request,
      [](std::size_t trials) {
        showProgress("trial", trials + 1, std::max<std::size_t>(trials + 2, 4));
      },
      stop);
  if (isInterrupted()) return Error{"Interrupted; nothing was written."};
  if (!result) return result.error();

  FolderContent content;
  content.texts = {{"calibration.toml", session::calibrationText(result->calibration)},
                   {"profile.csv", validation::profileCsv(result->fitted)},
                   {"difference.csv", validation::differenceCsv(result->fitted)}};
  content.figures = {{"calibration", draw(validation::calibrationFigure(*result, *experiment))}};
  if (const auto done = writeFolder(files, options.out, content); !done) return done.error();
  printSummary(*result, *experiment);
  return {};
}

}  // namespace perilymph::cli
