// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/validation/CalibrationFit.h"

#include <algorithm>
#include <cmath>
#include <stop_token>

namespace perilymph::validation {

namespace {

constexpr double forceTolerance = 1e-4;  // [N]; a fiftieth of the experiment's standard error
constexpr int maxTrials = 8;             // the force is nearly linear in the scale

/// Standard error of the experiment's mean: standard deviation / sqrt(insertions).
double standardError(const analysis::Reference& experiment, const analysis::PrintedForce& point)
{
  return point.standardDeviation / std::sqrt(std::max(1.0, experiment.insertions));
}

double forceAt(const ValidationResult& result, double travel)
{
  const auto index = static_cast<std::size_t>(std::lround(travel / analysis::profileStep().si()));
  return result.profile.at(index).force.mean;
}

/// A scale and the force with it.
struct Trial {
  double scale = 1.0;
  double force = 0.0;
};

}  // namespace

Result<CalibrationResult> fitCalibration(const CalibrationRequest& request,
                                         const PieceProgress& progress, const std::stop_token& stop)
{
  const analysis::PrintedForce* printed = request.experiment.find(fittedFeature);
  if (!printed || !(printed->standardDeviation > 0.0))
    return Error{
        "The reference '%1' lacks a point with feature = \"peak\" and its deviation; a calibration "
        "fits this one.",
        request.experiment.label};

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
  session::Calibration& calibration = result.calibration;
  calibration = session::uncalibrated(request.nominal.array);
  session::FittedValue& scale = calibration.stiffnessScale;
  const double curvature = calibration.residualCurvature.value;
  const auto run = [&](double at) -> Result<Trial> {
    trial.nominal.array = session::calibrated(request.nominal.array, at, curvature);
    auto insertions = validate(
        trial,
        [&](std::size_t, std::size_t) {
          if (progress) progress(static_cast<std::size_t>(result.trials));
        },
        stop);
    if (!insertions) return insertions.error();
    ++result.trials;
    result.fitted = std::move(*insertions);
    return Trial{at, forceAt(result.fitted, printed->travel)};
  };

  // secant method; the second scale as if the force were proportional
  const auto first = run(1.0);
  if (!first) return first.error();
  result.before = first->force;
  Trial last = *first, now = *first;
  double next = printed->mean / std::max(now.force, 1e-3);
  double slope = now.force;  // [N] per unit of the scale
  while (result.trials < maxTrials && std::fabs(now.force - printed->mean) > forceTolerance) {
    next = std::clamp(next, scale.low, scale.high);
    if (next == now.scale) break;  // held by a bound
    const auto there = run(next);
    if (!there) return there.error();
    last = now;
    now = *there;
    const double secant = (now.force - last.force) / (now.scale - last.scale);
    if (secant > 0.0) slope = secant;
    next = now.scale + (printed->mean - now.force) / slope;
  }

  const bool isHeld = now.scale == scale.low || now.scale == scale.high;
  scale.value = now.scale;
  scale.standardDeviation = isHeld ? 0.0 : standardError(request.experiment, *printed) / slope;
  calibration.residualCurvature = {curvature, 0.0, curvature, curvature};
  calibration.forces.push_back({printed->travel, printed->mean, now.force});
  calibration.label = request.nominal.array.name + ", fitted to " + request.experiment.label;
  calibration.source = "Fitted to the mean force at the basal-turn peak, nothing else, of: " +
                       request.experiment.source + ". " + std::to_string(request.runs) +
                       " insertions a trial, seed " + std::to_string(request.seed) + ".";
  return result;
}

}  // namespace perilymph::validation
