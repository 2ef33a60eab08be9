// SPDX-License-Identifier: BSD-3-Clause
#include "CurveLikelihood.h"

#include <cmath>

#include "perilymph/foundation/Math.h"
#include "perilymph/foundation/Units.h"

namespace perilymph::validation {

namespace {

constexpr double runDeviation = 0.15;
constexpr double shapeDeviation = 0.15;
constexpr double offset = 1.5e-3;           // N
constexpr double correlationLength = 3e-3;  // m

Eigen::VectorXd logarithms(const std::vector<double>& forces)
{
  Eigen::VectorXd logs(static_cast<Eigen::Index>(forces.size()));
  for (Eigen::Index i = 0; i < logs.size(); ++i)
    logs(i) = logarithm(forces[static_cast<std::size_t>(i)]);
  return logs;
}

}  // namespace

Eigen::MatrixXd curveCovariance(const std::vector<double>& depths,
                                const std::vector<double>& forces)
{
  const auto count = static_cast<Eigen::Index>(depths.size());
  const auto deviation = [&](Eigen::Index i) {
    const double relative = offset / forces[static_cast<std::size_t>(i)];
    return std::sqrt(relative * relative + shapeDeviation * shapeDeviation);
  };
  Eigen::MatrixXd covariance(count, count);
  for (Eigen::Index i = 0; i < count; ++i)
    for (Eigen::Index k = 0; k < count; ++k) {
      const double apart =
          std::fabs(depths[static_cast<std::size_t>(i)] - depths[static_cast<std::size_t>(k)]);
      covariance(i, k) = runDeviation * runDeviation +
                         deviation(i) * deviation(k) * exponential(-apart / correlationLength);
    }
  return covariance;
}

double LevelLikelihood::integrated() const { return best() + 0.5 * logarithm(2.0 * pi / weight); }

CurveLikelihood::CurveLikelihood(const std::vector<double>& depths,
                                 const std::vector<double>& forces)
    : factor_(curveCovariance(depths, forces)), logForce_(logarithms(forces))
{
  level_ = factor_.matrixL().solve(Eigen::VectorXd::Ones(logForce_.size()));
  constant_ = -0.5 * static_cast<double>(depths.size()) * logarithm(2.0 * pi);
  const Eigen::MatrixXd lower = factor_.matrixL();
  for (Eigen::Index i = 0; i < lower.rows(); ++i) constant_ -= logarithm(lower(i, i));
}

LevelLikelihood CurveLikelihood::of(const Eigen::VectorXd& logModel) const
{
  const Eigen::VectorXd white = factor_.matrixL().solve(logForce_ - logModel);
  return {constant_, white.squaredNorm(), level_.dot(white), level_.squaredNorm()};
}

Continuation continuationOf(const std::vector<double>& depths, const std::vector<double>& forces,
                            double laterDepth, double laterForce)
{
  std::vector<double> allDepths = depths, allForces = forces;
  allDepths.push_back(laterDepth);
  allForces.push_back(laterForce);
  const Eigen::MatrixXd all = curveCovariance(allDepths, allForces);
  const auto count = static_cast<Eigen::Index>(depths.size());
  const Eigen::VectorXd across = all.col(count).head(count);
  Continuation continuation;
  continuation.weights = all.topLeftCorner(count, count).llt().solve(across);
  continuation.deviation = std::sqrt(all(count, count) - across.dot(continuation.weights));
  return continuation;
}

}  // namespace perilymph::validation
