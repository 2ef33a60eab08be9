#include "solver/Descent.h"

#include <algorithm>
#include <cmath>

#include "perilymph/mechanics/advance.h"
#include "solver/NewtonStep.h"

namespace perilymph::mechanics {
namespace {

constexpr int maxTries = 12;           // along one step
constexpr double longestWay = 0.1e-3;  // [m] of one node in one step
// Of what drove a step, forces may still pull by so much at its end, either way.
constexpr double leftPull = 0.1;

/// The forces where a share of the step has been gone, of the wall as it is there.
Balance balanceAt(const InsertionModel& model, InsertionState& state, const Base& base,
                  double share, RodWorkspace& work) noexcept
{
  moveBy(work.system, share, state.position_W);
  std::fill(work.contacts.isKnown.begin(), work.contacts.isKnown.end(),
            static_cast<unsigned char>(0));
  return balance(model, state, base, work);
}

/// A place on the step: share of it, pull along it there [J].
struct Place {
  double share;
  double pull;
};

/// Goes along the step at most to `maxAlpha` of it, to where the forces hardly pull on or back.
Balance goDown(const InsertionModel& model, InsertionState& state, const Base& base, double start,
               double maxAlpha, RodWorkspace& work) noexcept
{
  const double enough = leftPull * start;
  Place low{0.0, start};
  Place high{maxAlpha, 0.0};
  Balance there = balanceAt(model, state, base, maxAlpha, work);
  high.pull = pullAlongWay(work.system, maxAlpha);
  // false position, which halves the weight of an end that stays
  double lowPull = low.pull, highPull = high.pull;
  for (int k = 0; k < maxTries && !(high.pull >= -enough); ++k) {
    double share = 0.5 * (low.share + high.share);
    if (std::isfinite(highPull) && k % 4 != 3)
      share = low.share +
              (high.share - low.share) * std::clamp(lowPull / (lowPull - highPull), 0.05, 0.95);
    there = balanceAt(model, state, base, share, work);
    const double pull = pullAlongWay(work.system, share);
    if (std::fabs(pull) <= enough) break;
    if (pull > 0.0) {
      low = {share, pull};
      lowPull = pull;
      highPull *= 0.5;
    } else {
      high = {share, pull};
      highPull = pull;
      lowPull *= 0.5;
    }
  }
  return there;
}

}  // namespace

Settled descend(const InsertionModel& model, InsertionState& state, const Base& base,
                Settled settled, RodWorkspace& work) noexcept
{
  auto& [now, iterations] = settled;
  const int last = iterations + maxDescentIterations;
  work.system.start_W = state.position_W;
  std::fill(work.contacts.isKnown.begin(), work.contacts.isKnown.end(),
            static_cast<unsigned char>(0));
  now = balance(model, state, base, work);
  for (; iterations < last && !(now.worst <= forceTolerance); ++iterations) {
    if (!factorize(model, base, work)) break;
    const double longest = findStep(work.system);
    work.system.start_W = state.position_W;
    const double pull = pullAlong(work.system);
    if (!(pull > 0.0) || !std::isfinite(longest)) break;
    now = goDown(model, state, base, pull, std::min(1.0, longestWay / longest), work);
  }
  work.system.factors.forget();
  return settled;
}

}  // namespace perilymph::mechanics
