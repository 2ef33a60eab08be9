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
constexpr int maxIterationsToRenew = 6;
// Oval sections are looked at anew until steps are as short as this.
constexpr double nearStep = 20e-6;  // [m]
// A Newton step with good factors leaves less than this share of the unbalanced forces.
constexpr double goodRatio = 0.1;
// A step is too long where forces then pull back with more than this share of what drove it.
constexpr double slopeTolerance = 0.3;

/// Whether a step has left only a good share of the unbalanced forces.
bool wasGood(const Residual& before, const Residual& after) noexcept
{
  return after.squaredNorm < goodRatio * goodRatio * before.squaredNorm;
}

/// Newton's method from state.position_W, where the forces are `now`.
SolveResult iterate(const InsertionModel& model, InsertionState& state, const Base& base,
                    SolveResult result, RodWorkspace& work) noexcept
{
  // Factors of an earlier step serve as long as their steps are good: the rod hardly changes from
  // one tick to the next. Where a contact toggles they are found anew.
  BandFactors& factors = work.system.factors;
  if (factors.firstIsHeld() != base.isHeld) factors.forget();
  bool areOwn = false;  // found in this step of time

  auto& [now, iterations] = result;
  for (; iterations < maxIterations && now.maxNorm > atRest; ++iterations) {
    if (!factors.exist()) {
      if (!factorize(model, base, work)) break;
      areOwn = true;
    }
    const double longest = solveLinearSystem(work.system);
    if (model.isOval && longest > nearStep && iterations < maxIterations / 4)
      for (SectionReach& section : work.contacts.section) section.isKnown = false;
    if (now.maxNorm <= forceTolerance && longest < motionTolerance) break;

    const double slope = directionalDerivative(work.system);
    work.system.start_W = state.position_W;
    double alpha = longest > longestStep ? longestStep / longest : 1.0;
    moveBy(work.system, alpha, state.position_W);
    Residual next = residual(model, state, base, work);
    if (!areOwn && !(next.squaredNorm < now.squaredNorm)) {
      // old factors led astray: back, and try with new ones
      factors.forget();
      moveBy(work.system, 0.0, state.position_W);
      now = residual(model, state, base, work);
      continue;
    }
    for (int halving = 0; halving < maxHalvings && !(next.squaredNorm <= now.squaredNorm);
         ++halving) {
      alpha *= 0.5;
      moveBy(work.system, alpha, state.position_W);
      next = residual(model, state, base, work);
    }
    // forces are those of an energy: if they now pull back along the step, its least is in between
    if (!wasGood(now, next)) {
      const double slopeThere = directionalDerivative(work.system);
      if (slopeThere < -slopeTolerance * slope) {
        const double wholeStep = alpha;
        alpha *= slope / (slope - slopeThere);
        moveBy(work.system, alpha, state.position_W);
        const Residual between = residual(model, state, base, work);
        if (between.squaredNorm < next.squaredNorm) {
          next = between;
        } else {
          alpha = wholeStep;
          moveBy(work.system, alpha, state.position_W);
          next = residual(model, state, base, work);
        }
      }
    }
    const bool goesOn = alpha * longest >= stuck || next.maxNorm <= forceTolerance ||
                        next.squaredNorm < minGain * now.squaredNorm;
    if (!wasGood(now, next)) factors.forget();
    now = next;
    if (areOwn && !goesOn) {
      ++iterations;
      break;
    }
  }
  return result;
}

}  // namespace

SolveResult solveNewton(const InsertionModel& model, InsertionState& state, const Base& base,
                        RodWorkspace& work) noexcept
{
  SolveResult result{residual(model, state, base, work), 0};
  double lag = std::numeric_limits<double>::infinity();
  for (int pass = 0;; ++pass) {
    result = iterate(model, state, base, result, work);
    if (pass == maxPasses || result.iterations > maxIterationsToRenew) break;
    const double before = lag;
    lag = frictionLag(model, state, work.contacts, work.friction);
    // where friction and pressure drive each other up, each step takes the pressure it started from
    if (lag <= maxLag || !(lag < 0.5 * before) || result.residual.maxNorm > forceTolerance) break;
    renewFriction(state, work.contacts, work.friction);
    result.residual = residual(model, state, base, work);
  }
  return result;
}

}  // namespace perilymph::mechanics
