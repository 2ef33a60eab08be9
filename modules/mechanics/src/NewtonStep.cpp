#include "NewtonStep.h"

#include <algorithm>
#include <cmath>

namespace perilymph::mechanics {
namespace {

/// One over the root of 1 + q.
double perRoot(double q) noexcept
{
  // left out is less than a rounding
  if (q < 1e-4) return 1.0 - q * (0.5 - q * (0.375 - q * 0.3125));
  return 1.0 / std::sqrt(1.0 + q);
}

}  // namespace

void moveBy(InsertionState& state, double share) noexcept
{
  const StepRoom& room = state.room;
  state.position_W[0] = room.start_W[0] + share * room.trial_W[0];
  state.position_W[1] = room.start_W[1] + share * room.trial_W[0];
  for (std::size_t i = 1; i + 1 < state.position_W.size(); ++i) {
    const Eigen::Vector3d edge = room.start_W[i + 1] - room.start_W[i];
    const Eigen::Vector3d change = share * (room.trial_W[i] - room.trial_W[i - 1]);
    const double perSquare = 1.0 / edge.squaredNorm();
    const double along = edge.dot(change) * perSquare;
    const double across = std::max(change.squaredNorm() * perSquare - along * along, 0.0);
    const double stretched = std::max(1.0 + along, 0.1);
    const double shrink = perRoot(across / (stretched * stretched));
    state.position_W[i + 1] = state.position_W[i] + shrink * (edge + change);
  }
}

double pullAlongWay(const InsertionState& state, double share) noexcept
{
  const StepRoom& room = state.room;
  Eigen::Vector3d motion = room.trial_W[0];
  double sum = room.right[0].dot(motion);
  for (std::size_t i = 1; i + 1 < state.position_W.size(); ++i) {
    const Eigen::Vector3d edge = room.start_W[i + 1] - room.start_W[i];
    const Eigen::Vector3d change = room.trial_W[i] - room.trial_W[i - 1];
    // the edge keeps the direction of `way`, and is `stretched` times as long as it was
    const Eigen::Vector3d way = edge + share * change;
    const double length = edge.norm();
    const double longer = edge.dot(change) / (length * length);
    const double stretched = 1.0 + share * longer;
    const double perWay = 1.0 / way.norm();
    const Eigen::Vector3d along = perWay * way;
    motion += (length * longer) * along +
              (length * stretched * perWay) * (change - along.dot(change) * along);
    sum += room.right[i].dot(motion);
  }
  return sum;
}

bool factorize(const InsertionModel& model, const Base& base, InsertionState& state) noexcept
{
  StepRoom& room = state.room;
  setStiffnessOfBalance(model, base, Compression::included, room);
  if (state.factors.factorize(room.matrix)) return true;
  // past its buckling load the exact matrix has no positive pivots; the safe one always has
  setStiffnessOfBalance(model, base, Compression::leftOut, room);
  return state.factors.factorize(room.matrix);
}

double findStep(InsertionState& state) noexcept
{
  StepRoom& room = state.room;
  room.trial_W = room.right;
  state.factors.solve(room.trial_W);
  double longest = 0.0;
  for (const Eigen::Vector3d& step : room.trial_W) longest = std::max(longest, step.squaredNorm());
  return std::sqrt(longest);
}

double pullAlong(const StepRoom& room) noexcept
{
  double sum[3] = {0.0, 0.0, 0.0};
  for (std::size_t i = 0; i < room.right.size(); ++i)
    for (int k = 0; k < 3; ++k) sum[k] += room.right[i][k] * room.trial_W[i][k];
  return sum[0] + sum[1] + sum[2];
}

}  // namespace perilymph::mechanics
