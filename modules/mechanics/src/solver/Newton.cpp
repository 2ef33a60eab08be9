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

constexpr int maxTries = 6;  // evaluations along one step
// Maximum remaining displacement of a node: small forces alone do not suffice, because a rod bends
// under very little. At rest, and as a fraction of the motion of the base in the step.
constexpr double motionTolerance = 0.2e-9;  // [m]
constexpr double motionFraction = 1e-3;
// Residual below which nothing moves.
constexpr double atRest = 1e-9;  // [N]
// Step length below which iteration has no effect: contact toggles.
constexpr double stuck = 1e-9;          // [m]
constexpr double minGain = 0.9;         // of the sum of squared forces
constexpr double longestStep = 0.5e-3;  // maximum displacement of one node in one iteration [m]
// Friction is bounded by an earlier pressure, renewed while its error may exceed this [N].
constexpr double maxLag = 0.1e-3;
constexpr int maxPasses = 2;
// A step that takes more iterations than this keeps the pressure at its start.
constexpr int maxIterationsToRenew = 6;
// Factors of an earlier step are good for steps shorter than this.
constexpr double farStep = 50e-6;  // [m]
// Oval sections are evaluated again after a first iteration that is longer than this.
constexpr double nearStep = 20e-6;  // [m]
// A step with good factors reduces the unbalanced forces below this fraction ...
constexpr double goodRatio = 0.1;
// ... and leaves a step that is shorter by this factor (measured: by 19 in the median, by 4.4 or more in
// 90 of 100).
constexpr double goodReduction = 5.0;
// A step is too long if the opposing slope at its end exceeds this fraction of that at its start.
constexpr double slopeTolerance = 0.3;

/// Whether a step reduced the unbalanced forces sufficiently.
bool wasGood(const Residual& before, const Residual& after) noexcept
{
  return after.squaredNorm < goodRatio * goodRatio * before.squaredNorm;
}

/// Whether no force is left unbalanced that matters, neither on a node nor, added up, at the hand.
bool isBalanced(const Residual& now) noexcept
{
  return now.maxNorm <= forceTolerance && now.total <= forceTolerance;
}

/// Number of points that an iteration may try: the bounds of the step leave room to go back from the
/// last one, and for two factorizations. 0: none.
int triesLeft(const RodWorkspace& work) noexcept
{
  if (work.done.factorizations + 2 > work.limit.factorizations) return 0;
  return std::clamp(work.limit.evaluations - work.done.evaluations - 1, 0, maxTries);
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
  const int tries = triesLeft(work);
  const Residual before = now;
  const double enough = slopeTolerance * start;
  Place low{0.0, start}, high{alpha, 0.0};
  // Illinois method: regula falsi that halves the weight of an end that stays
  double lowSlope = start, highSlope = 0.0;
  for (int k = 0; k < tries; ++k) {
    moveBy(work.system, alpha, state.position_W);
    now = residual(model, state, base, work);
    if (wasGood(before, now)) return alpha;
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
  // Factors of an earlier step are reused while they give good steps: the rod hardly changes from
  // one tick to the next. Where a contact toggles, the matrix is factorized again.
  BandFactors& factors = work.system.factors;
  if (factors.firstIsHeld() != base.isHeld) factors.forget();
  bool areOwn = false;  // factorized in this time step
  const double advance = (state.position_W[0] - work.start.position_W[0]).norm();
  const double shortest = std::max(motionTolerance, motionFraction * advance);

  auto& [now, iterations] = result;
  for (; triesLeft(work) > 0 && now.maxNorm > atRest; ++iterations) {
    if (!factors.exist()) {
      Compression compression = Compression::included;
      if (!factorize(model, base, compression, work)) break;
      areOwn = true;
    }
    const double longest = solveLinearSystem(work.system);
    if (!areOwn && longest > farStep) {
      factors.forget();
      continue;
    }
    if (model.isOval && longest > nearStep && iterations == 0)
      for (SectionReach& section : work.contacts.section) section.isKnown = false;
    if (isBalanced(now) && longest < shortest) break;
    // the sum may stay where nothing moves any more
    if (now.maxNorm <= forceTolerance && longest < motionTolerance && iterations > 0) break;

    const double slope = directionalDerivative(work.system);
    if (!(slope > 0.0) || !std::isfinite(longest)) break;
    work.system.start_W = state.position_W;
    const Residual before = now;
    const double alpha =
        lineSearch(model, state, base, slope, std::min(1.0, longestStep / longest), now, work);
    const bool isGood = wasGood(before, now);
    if (!isGood) factors.forget();
    if (isGood && isBalanced(now) && alpha * longest < goodReduction * shortest) {
      ++iterations;
      break;
    }
    const bool goesOn = alpha * longest >= stuck || now.maxNorm <= forceTolerance ||
                        now.squaredNorm < minGain * before.squaredNorm;
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
    if (pass == maxPasses || result.iterations > maxIterationsToRenew || triesLeft(work) == 0)
      break;
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
