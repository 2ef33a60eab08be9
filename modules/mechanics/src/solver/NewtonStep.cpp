// SPDX-License-Identifier: BSD-3-Clause
#include "solver/NewtonStep.h"

#include <algorithm>
#include <cmath>

namespace perilymph::mechanics {
namespace {

/// 1 / sqrt(1 + q).
double inverseRoot(double q) noexcept
{
  // truncation error below rounding
  if (q < 1e-4) return 1.0 - q * (0.5 - q * (0.375 - q * 0.3125));
  return 1.0 / std::sqrt(1.0 + q);
}

}  // namespace

void moveBy(const LinearSystem& system, double alpha,
            std::vector<Eigen::Vector3d>& position_W) noexcept
{
  position_W[0] = system.start_W[0] + alpha * system.trial_W[0];
  position_W[1] = system.start_W[1] + alpha * system.trial_W[0];
  for (std::size_t i = 1; i + 1 < system.start_W.size(); ++i) {
    const Eigen::Vector3d edge = system.start_W[i + 1] - system.start_W[i];
    const Eigen::Vector3d change = alpha * (system.trial_W[i] - system.trial_W[i - 1]);
    const double inverseSquare = 1.0 / edge.squaredNorm();
    const double along = edge.dot(change) * inverseSquare;
    const double across = std::max(change.squaredNorm() * inverseSquare - along * along, 0.0);
    const double stretched = std::max(1.0 + along, 0.1);
    const double shrink = inverseRoot(across / (stretched * stretched));
    position_W[i + 1] = position_W[i] + shrink * (edge + change);
  }
}

double directionalDerivativeAt(const LinearSystem& system, double alpha) noexcept
{
  Eigen::Vector3d motion = system.trial_W[0];
  double sum = system.right[0].dot(motion);
  for (std::size_t i = 1; i + 1 < system.start_W.size(); ++i) {
    const Eigen::Vector3d edge = system.start_W[i + 1] - system.start_W[i];
    const Eigen::Vector3d change = system.trial_W[i] - system.trial_W[i - 1];
    // the edge has the direction of `way` and `stretched` times its previous length
    const Eigen::Vector3d way = edge + alpha * change;
    const double length = edge.norm();
    const double longer = edge.dot(change) / (length * length);
    const double stretched = 1.0 + alpha * longer;
    const double inverseNorm = 1.0 / way.norm();
    const Eigen::Vector3d along = inverseNorm * way;
    motion += (length * longer) * along +
              (length * stretched * inverseNorm) * (change - along.dot(change) * along);
    sum += system.right[i].dot(motion);
  }
  return sum;
}

bool factorize(const InsertionModel& model, const Base& base, Compression& compression,
               RodWorkspace& work) noexcept
{
  if (compression == Compression::included) {
    ++work.done.factorizations;
    assembleStiffness(model, base, compression, work);
    if (work.system.factors.factorize(work.system.matrix)) return true;
    compression = Compression::leftOut;
  }
  ++work.done.factorizations;
  assembleStiffness(model, base, compression, work);
  return work.system.factors.factorize(work.system.matrix);
}

double solveLinearSystem(LinearSystem& system) noexcept
{
  system.trial_W = system.right;
  system.factors.solve(system.trial_W);
  double longest = 0.0;
  for (const Eigen::Vector3d& step : system.trial_W)
    longest = std::max(longest, step.squaredNorm());
  return std::sqrt(longest);
}

double directionalDerivative(const LinearSystem& system) noexcept
{
  double sum[3] = {0.0, 0.0, 0.0};
  for (std::size_t i = 0; i < system.right.size(); ++i)
    for (int k = 0; k < 3; ++k) sum[k] += system.right[i][k] * system.trial_W[i][k];
  return sum[0] + sum[1] + sum[2];
}

}  // namespace perilymph::mechanics
