#include "Newton.h"

#include <algorithm>
#include <cmath>

namespace perilymph::mechanics {
namespace {

constexpr int mostIterations = 16;
constexpr int mostHalvings = 3;
constexpr double forceTolerance = 2e-6;  // [N]
// What the nodes still would move: forces alone do not show it, for a rod bends under very little.
constexpr double motionTolerance = 0.2e-9;  // [m]
// Nothing moves at all.
constexpr double atRest = 1e-9;  // [N]
// A step so short that goes on for nothing: contact toggles.
constexpr double stuck = 1e-9;          // [m]
constexpr double longestStep = 0.2e-3;  // [m] of one node in one Newton step
// A Newton step with good factors leaves less than this share of the unbalanced forces.
constexpr double goodShare = 0.1;

/// Moves every node by a share of the Newton step that starts at room.start_W.
void moveBy(InsertionState& state, double share) noexcept
{
  const StepRoom& room = state.room;
  for (std::size_t i = 0; i < state.position_W.size(); ++i)
    state.position_W[i] = room.start_W[i] + share * room.trial_W[blockOf(i)];
}

/// Factors of the stiffness at the last balance. False only if there are none.
bool factorize(const InsertionModel& model, const Base& base, InsertionState& state) noexcept
{
  StepRoom& room = state.room;
  setStiffnessOfBalance(model, base, Compression::included, room);
  if (state.factors.factorize(room.matrix)) return true;
  // past its buckling load the exact matrix has no positive pivots; the safe one always has
  setStiffnessOfBalance(model, base, Compression::leftOut, room);
  return state.factors.factorize(room.matrix);
}

/// The Newton step of every block, into room.trial_W.
///
/// @return The longest of them [m].
double findStep(InsertionState& state) noexcept
{
  StepRoom& room = state.room;
  room.trial_W = room.right;
  state.factors.solve(room.trial_W);
  double longest = 0.0;
  for (const Eigen::Vector3d& step : room.trial_W) longest = std::max(longest, step.squaredNorm());
  return std::sqrt(longest);
}

/// Whether a step has left only a good share of the unbalanced forces.
bool wasGood(const Balance& before, const Balance& after) noexcept
{
  return after.squares < goodShare * goodShare * before.squares;
}

}  // namespace

Settled settle(const InsertionModel& model, InsertionState& state, const Base& base) noexcept
{
  // Factors of an earlier step serve as long as their steps are good: the rod hardly changes from
  // one tick to the next. Where a contact toggles they are found anew.
  BandFactors& factors = state.factors;
  if (factors.firstIsHeld() != base.isHeld) factors.forget();
  bool areOwn = false;  // found in this step of time

  Balance now = balance(model, state, base);
  int iterations = 0;
  for (; iterations < mostIterations && now.worst > atRest; ++iterations) {
    if (!factors.exist()) {
      if (!factorize(model, base, state)) break;
      areOwn = true;
    }
    const double longest = findStep(state);
    if (now.worst <= forceTolerance && longest < motionTolerance) break;

    state.room.start_W = state.position_W;
    double share = longest > longestStep ? longestStep / longest : 1.0;
    moveBy(state, share);
    Balance next = balance(model, state, base);
    if (!areOwn && !(next.squares < now.squares)) {
      // old factors led astray: back, and try with new ones
      factors.forget();
      moveBy(state, 0.0);
      now = balance(model, state, base);
      continue;
    }
    for (int halving = 0; halving < mostHalvings && !(next.squares <= now.squares); ++halving) {
      share *= 0.5;
      moveBy(state, share);
      next = balance(model, state, base);
    }
    const bool goesOn = share * longest >= stuck || next.worst <= forceTolerance;
    if (!wasGood(now, next)) factors.forget();
    now = next;
    if (areOwn && !goesOn) {
      ++iterations;
      break;
    }
  }
  return {now, iterations};
}

}  // namespace perilymph::mechanics
