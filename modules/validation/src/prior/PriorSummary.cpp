// SPDX-License-Identifier: BSD-3-Clause

// The printed forces beside the repetitions.

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "perilymph/analysis/RandomStream.h"
#include "perilymph/analysis/SampleStatistics.h"
#include "perilymph/foundation/Quantile.h"
#include "perilymph/validation/PriorPredictive.h"
#include "perilymph/validation/Validation.h"

namespace perilymph::validation {

namespace {

constexpr auto five = static_cast<int>(predictedForces);
using Vector = Eigen::Matrix<double, five, 1>;
using Matrix = Eigen::Matrix<double, five, five>;
/// Errors of the experiment's means: of the fitted force, then of the five.
using Errors = Eigen::Matrix<double, five + 1, 1>;
using Repetitions = std::vector<const RepeatedExperiment*>;

constexpr std::uint64_t errorPurpose = 400;
constexpr std::size_t fewestRepetitions =
    20;  // four for each force, for a covariance (choice, high)

/// A printed force: its mean, or the interval that holds it, and its standard error [N].
struct Printed {
  double low = 0.0, high = 0.0, standardError = 0.0;
};

std::optional<Printed> printedAt(const analysis::Reference& experiment, double travel_mm)
{
  const double root = std::sqrt(experiment.insertions);
  const auto isHere = [&](double travel) {
    return std::fabs(inMillimeters(meters(travel)) - travel_mm) < 0.01;
  };
  for (const analysis::PrintedForce& point : experiment.points)
    if (isHere(point.travel))
      return Printed{point.mean, point.mean, point.standardDeviation / root};
  for (const analysis::PrintedInterval& interval : experiment.intervals)
    if (isHere(interval.travel))
      return Printed{interval.low, interval.high, interval.standardDeviation / root};
  return std::nullopt;
}

/// Spearman's rank correlation; 0 if one of both is constant.
double rankCorrelation(const std::vector<double>& a, const std::vector<double>& b)
{
  const std::vector<double> x = analysis::ranksOf(a), y = analysis::ranksOf(b);
  const double middle = 0.5 * static_cast<double>(x.size() - 1);
  double xy = 0.0, xx = 0.0, yy = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    xy += (x[i] - middle) * (y[i] - middle);
    xx += (x[i] - middle) * (x[i] - middle);
    yy += (y[i] - middle) * (y[i] - middle);
  }
  return xx > 0.0 && yy > 0.0 ? xy / std::sqrt(xx * yy) : 0.0;
}

/// What the experiment's errors, correlated by `correlation`, add to the difference of prediction and
/// print: those of the five forces, and that of the fitted one times the slope.
class ErrorModel {
public:
  ErrorModel(const std::array<Printed, predictedForces + 1>& printed, const Vector& slope,
             double correlation)
      : correlation_(correlation)
  {
    for (int i = 0; i <= five; ++i) errors_[i] = printed[static_cast<std::size_t>(i)].standardError;
    jacobian_.leftCols<1>() = -slope;
    jacobian_.rightCols<five>().setIdentity();
  }

  Matrix covariance() const
  {
    Eigen::Matrix<double, five + 1, five + 1> all;
    for (int i = 0; i <= five; ++i)
      for (int k = 0; k <= five; ++k)
        all(i, k) = errors_[i] * errors_[k] * (i == k ? 1.0 : correlation_);
    return jacobian_ * all * jacobian_.transpose();
  }

  Vector draw(analysis::RandomStream& random) const
  {
    const double common = random.normal();
    Errors errors;
    for (int i = 0; i <= five; ++i)
      errors[i] = errors_[i] * (std::sqrt(correlation_) * common +
                                std::sqrt(1.0 - correlation_) * random.normal());
    return jacobian_ * errors;
  }

private:
  double correlation_;
  Errors errors_;
  Eigen::Matrix<double, five, five + 1> jacobian_;
};

Vector forcesOf(const RepeatedExperiment& repetition)
{
  Vector forces;
  for (int k = 0; k < five; ++k) forces[k] = repetition.force[static_cast<std::size_t>(k) + 1];
  return forces;
}

double fractionBelow(const std::vector<double>& values, double limit)
{
  return static_cast<double>(std::count_if(values.begin(), values.end(),
                                           [&](double value) { return value < limit; })) /
         static_cast<double>(values.size());
}

PredictedAnchor anchorOf(const Repetitions& repetitions, const std::vector<Vector>& withError,
                         std::size_t k, const Printed& printed)
{
  PredictedAnchor anchor;
  anchor.travel_mm = comparedTravels_mm[k + 1];
  anchor.low = printed.low;
  anchor.high = printed.high;
  anchor.standardError = printed.standardError;
  std::vector<double> forces, noisy;
  for (const RepeatedExperiment* each : repetitions) forces.push_back(each->force[k + 1]);
  for (const Vector& each : withError) noisy.push_back(each[static_cast<int>(k)]);
  const analysis::SampleStatistics statistics = analysis::statisticsOf(forces);
  anchor.mean = statistics.mean;
  anchor.deviation = statistics.standardDeviation;
  anchor.low90 = quantile(forces, 0.05);
  anchor.high90 = quantile(forces, 0.95);
  anchor.low90WithError = quantile(noisy, 0.05);
  anchor.high90WithError = quantile(noisy, 0.95);
  const double found = std::clamp(anchor.mean, printed.low, printed.high);
  anchor.rank = fractionBelow(forces, found);
  anchor.rankWithError = fractionBelow(noisy, found);
  anchor.isInside = found >= anchor.low90WithError && found <= anchor.high90WithError;
  for (std::size_t i = 0; i < inputCount; ++i) {
    std::vector<double> values;
    for (const RepeatedExperiment* each : repetitions) values.push_back(each->inputs[i]);
    anchor.correlation[i] = rankCorrelation(values, forces);
  }
  return anchor;
}

}  // namespace

Result<PriorSummary> summarize(const std::vector<RepeatedExperiment>& all,
                               const analysis::Reference& experiment)
{
  Repetitions repetitions;
  for (const RepeatedExperiment& each : all)
    if (each.reason.empty()) repetitions.push_back(&each);
  PriorSummary summary;
  summary.counted = static_cast<int>(repetitions.size());
  summary.leftOut = static_cast<int>(all.size() - repetitions.size());
  if (repetitions.size() < fewestRepetitions)
    return Error{
        "Only %1 of %2 repetitions can be fitted; a comparison needs at least %3. Widen the ranges "
        "or ask for more draws.",
        repetitions.size(), all.size(), fewestRepetitions};
  std::array<Printed, predictedForces + 1> printed;
  for (std::size_t k = 0; k < printed.size(); ++k) {
    const auto there = printedAt(experiment, comparedTravels_mm[k]);
    if (!there || !(experiment.insertions > 0.0))
      return Error{"The reference '%1' has no force at %2 mm, or does not say of how many.",
                   experiment.label, static_cast<int>(comparedTravels_mm[k])};
    printed[k] = *there;
  }

  const double count = static_cast<double>(repetitions.size());
  Vector mean = Vector::Zero(), slope = Vector::Zero();
  for (const RepeatedExperiment* each : repetitions) {
    mean += forcesOf(*each) / count;
    for (int k = 0; k < five; ++k) slope[k] += each->slope[static_cast<std::size_t>(k) + 1] / count;
  }
  Matrix covariance = Matrix::Zero();
  for (const RepeatedExperiment* each : repetitions) {
    const Vector away = forcesOf(*each) - mean;
    covariance += away * away.transpose() / (count - 1.0);
  }
  Vector found;
  for (int k = 0; k < five; ++k) {
    const Printed& print = printed[static_cast<std::size_t>(k) + 1];
    found[k] = std::clamp(mean[k], print.low, print.high);
  }

  for (const double correlation : {0.0, 0.7}) {
    const ErrorModel errors(printed, slope, correlation);
    const Matrix total = covariance + errors.covariance();
    const Eigen::LDLT<Matrix> factors(total);
    const auto distanceOf = [&](const Vector& forces) {
      const Vector away = forces - mean;
      return away.dot(factors.solve(away));
    };
    std::vector<Vector> withError;
    for (const RepeatedExperiment* each : repetitions) {
      analysis::RandomStream random(1, each->number, errorPurpose);
      withError.push_back(forcesOf(*each) + errors.draw(random));
    }
    JointTest joint;
    joint.correlation = correlation;
    joint.distance = distanceOf(found);
    joint.pValue = chiSquareTail(joint.distance, five);
    for (const Vector& each : withError)
      joint.counted += (distanceOf(each) >= joint.distance ? 1.0 : 0.0) / count;
    summary.joint.push_back(joint);
    if (correlation > 0.0) continue;
    for (std::size_t k = 0; k < predictedForces; ++k)
      summary.anchors.push_back(anchorOf(repetitions, withError, k, printed[k + 1]));
  }
  return summary;
}

}  // namespace perilymph::validation
