// SPDX-License-Identifier: BSD-3-Clause
#include "solver/NewtonStep.h"

#include <algorithm>
#include <cmath>

#include "lanes/Lanes.h"

namespace perilymph::mechanics {
namespace {

/// 1 / sqrt(1 + q).
template <class T>
PERILYMPH_IN_LANES T inverseRoot(const T& q) noexcept
{
  // truncation error below rounding
  const T series = 1.0 - q * (0.5 - q * (0.375 - q * 0.3125));
  const auto isSmall = q < 1e-4;
  if (inAll(isSmall)) return series;
  return oneOf(isSmall, series, T(1.0 / root(T(1.0 + q))));
}

}  // namespace

void moveBy(LinearSystem& system, double alpha, std::vector<Eigen::Vector3d>& position_W) noexcept
{
  const std::size_t nodes = system.start_W.size();
  inLanes(1, nodes - 1, [&](auto lane, std::size_t i) PERILYMPH_KERNEL {
    using T = decltype(lane);
    const Triple<T> edge = load<T>(system.start_W, i + 1) - load<T>(system.start_W, i);
    const Triple<T> change =
        (T{} + alpha) * (load<T>(system.trial_W, i) - load<T>(system.trial_W, i - 1));
    const T inverseSquare = 1.0 / dot(edge, edge);
    const T along = dot(edge, change) * inverseSquare;
    const T across = larger(dot(change, change) * inverseSquare - along * along, 0.0);
    const T stretched = larger(1.0 + along, 0.1);
    const T shrink = inverseRoot(T(across / (stretched * stretched)));
    store(shrink * (edge + change), system.edge_W, i);
  });
  position_W[0] = system.start_W[0] + alpha * system.trial_W[0];
  position_W[1] = system.start_W[1] + alpha * system.trial_W[0];
  Eigen::Vector3d at_W = position_W[1];
  const Eigen::Vector3d* edge_W = system.edge_W.data();
  Eigen::Vector3d* to_W = position_W.data();
  for (std::size_t i = 1; i + 1 < nodes; ++i) {
    at_W += edge_W[i];
    to_W[i + 1] = at_W;
  }
}

double directionalDerivativeAt(LinearSystem& system, double alpha) noexcept
{
  const std::size_t nodes = system.start_W.size();
  inLanes(1, nodes - 1, [&](auto lane, std::size_t i) PERILYMPH_KERNEL {
    using T = decltype(lane);
    const Triple<T> edge = load<T>(system.start_W, i + 1) - load<T>(system.start_W, i);
    const Triple<T> change = load<T>(system.trial_W, i) - load<T>(system.trial_W, i - 1);
    // the edge has the direction of `way` and `stretched` times its previous length
    const Triple<T> way = edge + (T{} + alpha) * change;
    const T length = root(dot(edge, edge));
    const T longer = dot(edge, change) / (length * length);
    const T stretched = 1.0 + alpha * longer;
    const T inverseNorm = 1.0 / root(dot(way, way));
    const Triple<T> along = inverseNorm * way;
    const T lengthens = length * longer, turns = length * stretched * inverseNorm;
    store(lengthens * along + turns * (change - dot(along, change) * along), system.edge_W, i);
  });
  Eigen::Vector3d motion = system.trial_W[0];
  const Eigen::Vector3d *edge_W = system.edge_W.data(), *right = system.right.data();
  double sum = right[0].dot(motion);
  for (std::size_t i = 1; i + 1 < nodes; ++i) {
    motion += edge_W[i];
    sum += right[i].dot(motion);
  }
  return sum;
}

bool factorize(const InsertionModel& model, const InsertionState& state, const Base& base,
               Compression& compression, RodWorkspace& work) noexcept
{
  if (compression == Compression::included) {
    ++work.done.factorizations;
    assembleStiffness(model, state, base, compression, work);
    if (work.system.factors.factorize(work.system.matrix)) return true;
    compression = Compression::leftOut;
  }
  ++work.done.factorizations;
  assembleStiffness(model, state, base, compression, work);
  return work.system.factors.factorize(work.system.matrix);
}

double solveLinearSystem(LinearSystem& system) noexcept
{
  copy(system.right, system.trial_W);
  system.factors.solve(system.trial_W);
  Four longest{};
  withLanes([&]() PERILYMPH_KERNEL {
    Four longestOfLane{};
    std::size_t i = 0;
    for (; i + 4 <= system.trial_W.size(); i += 4) {
      const Triple<Four> step = load<Four>(system.trial_W, i);
      longestOfLane = larger(longestOfLane, dot(step, step));
    }
    for (; i < system.trial_W.size(); ++i) {
      const Triple<double> step = load<double>(system.trial_W, i);
      longestOfLane = larger(longestOfLane, dot(step, step));
    }
    longest = longestOfLane;
  });
  return std::sqrt(std::max({longest[0], longest[1], longest[2], longest[3]}));
}

double directionalDerivative(const LinearSystem& system) noexcept
{
  Four sums{};  // per axis
  withLanes([&]() PERILYMPH_KERNEL {
    Four sum{};
    forEachVector(system.right, system.trial_W,
                  [&](const Four& force, const Four& step)
                      PERILYMPH_KERNEL { sum += force * step; });
    sums = sum;
  });
  return sums[0] + sums[1] + sums[2];
}

}  // namespace perilymph::mechanics
