// SPDX-License-Identifier: BSD-3-Clause
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
// Maximum remaining displacement of a node: small forces alone do not suffice, because a rod bends
// under very little.
constexpr double motionTolerance = 0.2e-9;  // [m]
// Residual below which nothing moves.
constexpr double atRest = 1e-9;  // [N]
// Step length below which iteration has no effect: contact toggles.
constexpr double stuck = 1e-9;          // [m]
constexpr double minGain = 0.9;         // of the sum of squared forces
constexpr double longestStep = 0.5e-3;  // maximum displacement of one node in one Newton step [m]
// Friction is bounded by an earlier pressure, renewed while its error may exceed this [N].
constexpr double maxLag = 0.1e-3;
constexpr int maxPasses = 2;
// A step that takes more iterations than this keeps the pressure at its start.
constexpr int maxIterationsToRenew = 6;
// Oval sections are re-evaluated until steps are shorter than this.
constexpr double nearStep = 20e-6;  // [m]
// A Newton step with good factors reduces the unbalanced forces below this fraction.
constexpr double goodRatio = 0.1;
// A step is too long if the opposing slope at its end exceeds this fraction of that at its start.
constexpr double slopeTolerance = 0.3;

/// Whether a step reduced the unbalanced forces sufficiently.
bool wasGood(const Residual& before, const Residual& after) noexcept
{
  return after.squaredNorm < goodRatio * goodRatio * before.squaredNorm;
}

/// Newton's method from state.position_W, where the residual is `now`.
SolveResult iterate(const InsertionModel& model, InsertionState& state, const Base& base,
                    SolveResult result, RodWorkspace& work) noexcept
{
  // Factors of an earlier step are reused while they give good steps: the rod hardly changes from
  // one tick to the next. Where a contact toggles, the matrix is factorized again.
  BandFactors& factors = work.system.factors;
  if (factors.firstIsHeld() != base.isHeld) factors.forget();
  bool areOwn = false;  // factorized in this time step

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
      // the old factors gave a bad step: go back and factorize again
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
    // forces derive from an energy: if the slope changes sign along the step, the minimum is in
    // between
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
    // where friction and pressure amplify each other, each step keeps the pressure at its start
    if (lag <= maxLag || !(lag < 0.5 * before) || result.residual.maxNorm > forceTolerance) break;
    renewFriction(state, work.contacts, work.friction);
    result.residual = residual(model, state, base, work);
  }
  return result;
}

}  // namespace perilymph::mechanics
