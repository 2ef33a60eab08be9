#include "solver/Newton.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "contact/Contact.h"
#include "perilymph/mechanics/advance.h"
#include "solver/NewtonStep.h"

namespace perilymph::mechanics {
namespace {

constexpr int maxHalvings = 3;
// What the nodes still would move: forces alone do not show it, for a rod bends under very little.
constexpr double motionTolerance = 0.2e-9;  // [m]
// Nothing moves at all.
constexpr double atRest = 1e-9;  // [N]
// A step so short that goes on for nothing: contact toggles.
constexpr double stuck = 1e-9;          // [m]
constexpr double minGain = 0.9;         // of the squares of all forces
constexpr double longestStep = 0.5e-3;  // [m] of one node in one Newton step
// Friction is bounded by an older pressure, renewed while it may be wrong by more than this [N].
constexpr double maxLag = 0.1e-3;
constexpr int maxPasses = 2;
// A step that takes more iterations than this is left with the pressure it started from.
constexpr int soonSettled = 6;
// Oval sections are looked at anew until steps are as short as this.
constexpr double nearStep = 20e-6;  // [m]
// A Newton step with good factors leaves less than this share of the unbalanced forces.
constexpr double goodShare = 0.1;
// A step is too long where forces then pull back with more than this share of what drove it.
constexpr double leftPull = 0.3;

/// Whether a step has left only a good share of the unbalanced forces.
bool wasGood(const Balance& before, const Balance& after) noexcept
{
  return after.squares < goodShare * goodShare * before.squares;
}

/// Newton's method from state.position_W, where the forces are `now`.
Settled iterate(const InsertionModel& model, InsertionState& state, const Base& base,
                Settled settled, RodWorkspace& work) noexcept
{
  // Factors of an earlier step serve as long as their steps are good: the rod hardly changes from
  // one tick to the next. Where a contact toggles they are found anew.
  BandFactors& factors = work.system.factors;
  if (factors.firstIsHeld() != base.isHeld) factors.forget();
  bool areOwn = false;  // found in this step of time

  auto& [now, iterations] = settled;
  for (; iterations < maxIterations && now.worst > atRest; ++iterations) {
    if (!factors.exist()) {
      if (!factorize(model, base, work)) break;
      areOwn = true;
    }
    const double longest = findStep(work.system);
    if (model.isOval && longest > nearStep && iterations < maxIterations / 4)
      for (SectionReach& section : work.contacts.section) section.isKnown = false;
    if (now.worst <= forceTolerance && longest < motionTolerance) break;

    const double pull = pullAlong(work.system);
    work.system.start_W = state.position_W;
    double share = longest > longestStep ? longestStep / longest : 1.0;
    moveBy(work.system, share, state.position_W);
    Balance next = balance(model, state, base, work);
    if (!areOwn && !(next.squares < now.squares)) {
      // old factors led astray: back, and try with new ones
      factors.forget();
      moveBy(work.system, 0.0, state.position_W);
      now = balance(model, state, base, work);
      continue;
    }
    for (int halving = 0; halving < maxHalvings && !(next.squares <= now.squares); ++halving) {
      share *= 0.5;
      moveBy(work.system, share, state.position_W);
      next = balance(model, state, base, work);
    }
    // forces are those of an energy: if they now pull back along the step, its least is in between
    if (!wasGood(now, next)) {
      const double back = pullAlong(work.system);
      if (back < -leftPull * pull) {
        const double whole = share;
        share *= pull / (pull - back);
        moveBy(work.system, share, state.position_W);
        const Balance between = balance(model, state, base, work);
        if (between.squares < next.squares) {
          next = between;
        } else {
          share = whole;
          moveBy(work.system, share, state.position_W);
          next = balance(model, state, base, work);
        }
      }
    }
    const bool goesOn = share * longest >= stuck || next.worst <= forceTolerance ||
                        next.squares < minGain * now.squares;
    if (!wasGood(now, next)) factors.forget();
    now = next;
    if (areOwn && !goesOn) {
      ++iterations;
      break;
    }
  }
  return settled;
}

}  // namespace

Settled settle(const InsertionModel& model, InsertionState& state, const Base& base,
               RodWorkspace& work) noexcept
{
  Settled settled{balance(model, state, base, work), 0};
  double lag = std::numeric_limits<double>::infinity();
  for (int pass = 0;; ++pass) {
    settled = iterate(model, state, base, settled, work);
    if (pass == maxPasses || settled.iterations > soonSettled) break;
    const double before = lag;
    lag = frictionLag(model, state, work.contacts, work.friction);
    // where friction and pressure drive each other up, each step takes the pressure it started from
    if (lag <= maxLag || !(lag < 0.5 * before) || settled.left.worst > forceTolerance) break;
    renewFriction(state, work.contacts, work.friction);
    settled.left = balance(model, state, base, work);
  }
  return settled;
}

}  // namespace perilymph::mechanics
