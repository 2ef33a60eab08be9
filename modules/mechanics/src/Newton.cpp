#include "Newton.h"

#include <algorithm>
#include <cmath>

namespace perilymph::mechanics {
namespace {

constexpr int mostIterations = 16;
constexpr int mostHalvings = 3;
constexpr double forceTolerance = 2e-6;   // [N]
constexpr double motionTolerance = 1e-9;  // [m]
constexpr double longestStep = 0.2e-3;    // [m] of one node in one Newton step

/// Moves every node by a share of the Newton step that starts at room.start_W.
void moveBy(InsertionState& state, double share) noexcept
{
  const StepRoom& room = state.room;
  for (std::size_t i = 0; i < state.position_W.size(); ++i)
    state.position_W[i] = room.start_W[i] + share * room.trial_W[blockOf(i)];
}

/// Factors of the stiffness at the last balance. False only if there are none.
bool factorize(const InsertionModel& model, const Base& base, StepRoom& room) noexcept
{
  setStiffnessOfBalance(model, base, Compression::included, room);
  if (room.system.factorize()) return true;
  // past its buckling load the exact matrix has no positive pivots; the safe one always has
  setStiffnessOfBalance(model, base, Compression::leftOut, room);
  return room.system.factorize();
}

/// The Newton step of every block, into room.trial_W.
///
/// @return The longest of them [m].
double findStep(StepRoom& room) noexcept
{
  room.trial_W = room.right;
  room.system.solve(room.trial_W);
  double longest = 0.0;
  for (const Eigen::Vector3d& step : room.trial_W) longest = std::max(longest, step.squaredNorm());
  return std::sqrt(longest);
}

}  // namespace

Settled settle(const InsertionModel& model, InsertionState& state, const Base& base) noexcept
{
  StepRoom& room = state.room;
  Balance now = balance(model, state, base);
  int iterations = 0;
  while (iterations < mostIterations && now.worst > forceTolerance) {
    if (!factorize(model, base, room)) break;
    const double longest = findStep(room);
    room.start_W = state.position_W;

    double share = longest > longestStep ? longestStep / longest : 1.0;
    moveBy(state, share);
    Balance next = balance(model, state, base);
    for (int halving = 0; halving < mostHalvings && !(next.squares <= now.squares); ++halving) {
      share *= 0.5;
      moveBy(state, share);
      next = balance(model, state, base);
    }
    now = next;
    ++iterations;
    if (share * longest < motionTolerance) break;
  }
  return {now, iterations};
}

}  // namespace perilymph::mechanics
