// SPDX-License-Identifier: BSD-3-Clause
#include "solver/Newton.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "contact/Contact.h"
#include "solver/NewtonStep.h"

namespace perilymph::mechanics {
namespace {

/// Whether a step reduced the unbalanced forces below this fraction.
bool reduced(const Residual& before, const Residual& after, double ratio) noexcept
{
  return after.squaredNorm < ratio * ratio * before.squaredNorm;
}

/// Whether no force is left unbalanced that matters, neither on a node nor, added up, at the hand.
bool isBalanced(const SolverParameters& law, const Residual& now) noexcept
{
  return now.maxNorm <= law.forceTolerance && now.total <= law.forceTolerance;
}

/// Number of points that an iteration may try: the bounds of the step leave room to go back from the
/// last one, and for two factorizations. 0: none.
int triesLeft(const SolverParameters& law, const StepWork& done) noexcept
{
  if (done.factorizations + 2 > law.maxFactorizations) return 0;
  return std::clamp(law.maxEvaluations - done.evaluations - 1, 0, law.maxTries);
}

/// A point on a step: its fraction, and the directional derivative there [J].
struct Place {
  double alpha;
  double slope;
};

/// Moves along the step that starts at system.start_W with the residual `now` and the slope `start`,
/// by the fraction `alpha` or less, to a point of lower energy: one with a good residual or where the
/// slope nearly vanishes, else one before it. The change of energy is that of the trapezoid between
/// the slopes at both ends.
///
/// @return The fraction, 0 if it stays.
double lineSearch(const InsertionModel& model, InsertionState& state, const Base& base,
                  double start, double alpha, Residual& now, RodWorkspace& work) noexcept
{
  const SolverParameters& law = model.parts.solver;
  const int tries = triesLeft(law, work.done);
  const Residual before = now;
  const double enough = law.slopeTolerance * start;
  Place low{0.0, start}, high{alpha, 0.0};
  // Illinois method: regula falsi that halves the weight of an end that stays
  double lowSlope = start, highSlope = 0.0;
  for (int k = 0; k < tries; ++k) {
    moveBy(work.system, alpha, state.position_W);
    now = residual(model, state, base, work);
    if (reduced(before, now, law.goodRatio)) return alpha;
    const double slope = directionalDerivativeAt(work.system, alpha);
    if (slope >= -enough && (k == 0 || slope <= enough)) return alpha;
    if (slope > 0.0) {
      low = {alpha, slope};
      lowSlope = slope;
      highSlope *= 0.5;
    } else {
      high = {alpha, slope};
      highSlope = slope;
      lowSlope *= 0.5;
    }
    const double fraction = std::isfinite(highSlope) ? lowSlope / (lowSlope - highSlope) : 0.1;
    alpha = low.alpha + (high.alpha - low.alpha) * std::clamp(fraction, 0.2, 0.8);
  }
  moveBy(work.system, low.alpha, state.position_W);
  now = residual(model, state, base, work);
  return low.alpha;
}

/// Newton's method from state.position_W, where the residual is `now`.
SolveResult iterate(const InsertionModel& model, InsertionState& state, const Base& base,
                    SolveResult result, RodWorkspace& work) noexcept
{
  const SolverParameters& law = model.parts.solver;
  // Factors of an earlier step are reused while they give good steps: the rod hardly changes from
  // one tick to the next. Where a contact toggles, the matrix is factorized again.
  BandFactors& factors = work.system.factors;
  if (factors.firstIsHeld() != base.isHeld) factors.invalidate();
  bool areOwn = false;  // factorized in this time step
  const double advance = (state.position_W[0] - work.start.position_W[0]).norm();
  const double shortest = std::max(law.motionTolerance, law.motionFraction * advance);

  auto& [now, iterations] = result;
  work.system.stepRemains = false;
  for (; triesLeft(law, work.done) > 0 && now.maxNorm > law.atRest; ++iterations) {
    if (!factors.exist()) {
      Compression compression = Compression::included;
      if (!factorize(model, state, base, compression, work)) break;
      areOwn = true;
    }
    const double longest = solveLinearSystem(work.system);
    if (!areOwn && longest > law.farStep) {
      factors.invalidate();
      continue;
    }
    if (model.isOval && longest > law.nearStep && iterations == 0)
      for (SectionReach& section : work.contacts.section) section.isKnown = false;
    // the sum may stay where nothing moves any more
    work.system.stepRemains =
        (isBalanced(law, now) && longest < shortest) ||
        (now.maxNorm <= law.forceTolerance && longest < law.motionTolerance && iterations > 0);
    if (work.system.stepRemains) break;

    const double slope = directionalDerivative(work.system);
    if (!(slope > 0.0) || !std::isfinite(longest)) break;
    copy(state.position_W, work.system.start_W);
    const Residual before = now;
    const double alpha =
        lineSearch(model, state, base, slope, std::min(1.0, law.longestStep / longest), now, work);
    if (!reduced(before, now, law.keptRatio)) factors.invalidate();
    if (reduced(before, now, law.goodRatio) && isBalanced(law, now) &&
        alpha * longest < law.goodReduction * shortest) {
      ++iterations;
      break;
    }
    const bool goesOn = alpha * longest >= law.stuck || now.maxNorm <= law.forceTolerance ||
                        now.squaredNorm < law.minGain * before.squaredNorm;
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
  const SolverParameters& law = model.parts.solver;
  SolveResult result{residual(model, state, base, work), 0};
  double lag = std::numeric_limits<double>::infinity();
  for (int pass = 0;; ++pass) {
    result = iterate(model, state, base, result, work);
    if (pass == law.maxPasses || result.iterations > law.maxIterationsToRenew ||
        triesLeft(law, work.done) == 0)
      break;
    const double before = lag;
    lag = frictionLag(model, state, work.contacts, work.friction);
    // where friction and pressure amplify each other, each step keeps the pressure it has
    if (lag <= law.maxLag || !(lag < 0.5 * before) || result.residual.maxNorm > law.forceTolerance)
      break;
    renewFriction(state, work.contacts, work.friction);
    result.residual = residual(model, state, base, work);
  }
  return result;
}

}  // namespace perilymph::mechanics
