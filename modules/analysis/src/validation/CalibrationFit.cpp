// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/analysis/CalibrationFit.h"

#include <cmath>

#include "validation/GaussNewton2.h"

namespace perilymph::analysis {

namespace {

/// Standard error of the experiment's mean: standard deviation / sqrt(insertions).
double standardError(const Reference& experiment, const PrintedForce& point)
{
  return point.standardDeviation / std::sqrt(std::max(1.0, experiment.insertions));
}

double forceAt(const ValidationResult& result, double travel)
{
  const auto index = static_cast<std::size_t>(std::lround(travel / profileStep().si()));
  return result.profile.at(index).force.mean;
}

}  // namespace

double chiSquareTail(double chiSquare, int degreesOfFreedom)
{
  if (degreesOfFreedom == 1) return std::erfc(std::sqrt(0.5 * chiSquare));
  if (degreesOfFreedom == 2) return std::exp(-0.5 * chiSquare);
  return 1.0;
}

Result<CalibrationResult> fitCalibration(const CalibrationRequest& request,
                                         const CalibrationProgress& progress)
{
  const PrintedForce* peak = request.experiment.find("peak");
  const PrintedForce* maximum = request.experiment.find("maximum");
  if (!peak || !maximum || !(peak->standardDeviation > 0.0) || !(maximum->standardDeviation > 0.0))
    return Error{"The reference '" + request.experiment.label +
                 "' lacks a point with feature = \"peak\" or \"maximum\" and its deviation; a "
                 "calibration fits these two."};

  ValidationRequest trial;
  trial.nominal = request.nominal;
  trial.variability = request.variability;
  trial.experiment = request.experiment;
  trial.runs = request.runs;
  trial.seed = request.seed;
  trial.jobs = request.jobs;
  trial.runsPerSource = 0;
  auto anatomy = session::buildAnatomy(request.nominal);
  if (!anatomy) return anatomy.error();
  trial.anatomy = *anatomy;

  CalibrationResult result;
  // Residuals in standard errors of the experiment, so that the fit yields standard errors.
  const auto residuals = [&](const TwoNumbers& at) -> Result<TwoNumbers> {
    trial.nominal.array = session::calibrated(request.nominal.array, at.a, at.b);
    auto run = validate(trial, [&](std::size_t, std::size_t) {
      return !progress || progress(static_cast<std::size_t>(result.trials));
    });
    if (!run) return run.error();
    ++result.trials;
    result.fitted = std::move(*run);
    return TwoNumbers{(forceAt(result.fitted, peak->travel) - peak->mean) /
                          standardError(request.experiment, *peak),
                      (forceAt(result.fitted, maximum->travel) - maximum->mean) /
                          standardError(request.experiment, *maximum)};
  };

  session::Calibration& calibration = result.calibration;
  calibration = session::uncalibrated(request.nominal.array);
  session::FittedValue& scale = calibration.stiffnessScale;
  session::FittedValue& curvature = calibration.residualCurvature;
  const TwoBounds bounds{{scale.low, curvature.low}, {scale.high, curvature.high}, {0.05, 0.01}, 4};
  const auto before = residuals({1.0, curvature.value});
  if (!before) return before.error();
  const auto chiSquare = [](const TwoNumbers& r) { return r.a * r.a + r.b * r.b; };
  result.chiSquareBefore = chiSquare(*before);

  const auto fit = gaussNewton2(residuals, {1.0, curvature.value}, bounds);
  if (!fit) return fit.error();
  const auto there = residuals(fit->at);  // the result then holds the curve of the fit
  if (!there) return there.error();
  result.chiSquare = chiSquare(*there);
  for (const double determined : {fit->standardDeviation.a, fit->standardDeviation.b})
    result.degreesOfFreedom += determined > 0.0 ? 0 : 1;
  result.pValue = chiSquareTail(result.chiSquare, result.degreesOfFreedom);
  scale.value = fit->at.a;
  scale.standardDeviation = fit->standardDeviation.a;
  curvature.value = fit->at.b;
  curvature.standardDeviation = fit->standardDeviation.b;
  for (const PrintedForce* point : {peak, maximum})
    calibration.forces.push_back(
        {point->travel, point->mean, forceAt(result.fitted, point->travel)});
  calibration.label = request.nominal.array.name + ", fitted to " + request.experiment.label;
  calibration.source =
      "Fitted to the mean forces at the basal-turn peak and at the maximum, nothing "
      "else, of: " +
      request.experiment.source + ". " + std::to_string(request.runs) +
      " insertions a trial, seed " + std::to_string(request.seed) + ".";
  return result;
}

}  // namespace perilymph::analysis
