#include "solver/Descent.h"

#include <algorithm>
#include <cmath>

#include "perilymph/mechanics/advance.h"
#include "solver/NewtonStep.h"

namespace perilymph::mechanics {
namespace {

constexpr int maxTries = 12;            // along one step
constexpr double longestStep = 0.1e-3;  // [m] of one node in one step
// Of what drove a step, forces may still pull by so much at its end, either way.
constexpr double slopeTolerance = 0.1;

/// The forces where a share of the step has been gone, of the wall as it is there.
Residual residualAt(const InsertionModel& model, InsertionState& state, const Base& base,
                    double alpha, RodWorkspace& work) noexcept
{
  moveBy(work.system, alpha, state.position_W);
  std::fill(work.contacts.isKnown.begin(), work.contacts.isKnown.end(),
            static_cast<unsigned char>(0));
  return residual(model, state, base, work);
}

/// A place on the step: share of it, pull along it there [J].
struct Place {
  double alpha;
  double slope;
};

/// Goes along the step at most to `maxAlpha` of it, to where the forces hardly pull on or back.
Residual lineSearch(const InsertionModel& model, InsertionState& state, const Base& base,
                    double start, double maxAlpha, RodWorkspace& work) noexcept
{
  const double enough = slopeTolerance * start;
  Place low{0.0, start};
  Place high{maxAlpha, 0.0};
  Residual there = residualAt(model, state, base, maxAlpha, work);
  high.slope = directionalDerivativeAt(work.system, maxAlpha);
  // false position, which halves the weight of an end that stays
  double lowSlope = low.slope, highSlope = high.slope;
  for (int k = 0; k < maxTries && !(high.slope >= -enough); ++k) {
    double alpha = 0.5 * (low.alpha + high.alpha);
    if (std::isfinite(highSlope) && k % 4 != 3)
      alpha = low.alpha +
              (high.alpha - low.alpha) * std::clamp(lowSlope / (lowSlope - highSlope), 0.05, 0.95);
    there = residualAt(model, state, base, alpha, work);
    const double slope = directionalDerivativeAt(work.system, alpha);
    if (std::fabs(slope) <= enough) break;
    if (slope > 0.0) {
      low = {alpha, slope};
      lowSlope = slope;
      highSlope *= 0.5;
    } else {
      high = {alpha, slope};
      highSlope = slope;
      lowSlope *= 0.5;
    }
  }
  return there;
}

}  // namespace

SolveResult minimizeEnergy(const InsertionModel& model, InsertionState& state, const Base& base,
                           SolveResult result, RodWorkspace& work) noexcept
{
  auto& [now, iterations] = result;
  const int last = iterations + maxDescentIterations;
  work.system.start_W = state.position_W;
  std::fill(work.contacts.isKnown.begin(), work.contacts.isKnown.end(),
            static_cast<unsigned char>(0));
  now = residual(model, state, base, work);
  for (; iterations < last && !(now.maxNorm <= forceTolerance); ++iterations) {
    if (!factorize(model, base, work)) break;
    const double longest = solveLinearSystem(work.system);
    work.system.start_W = state.position_W;
    const double slope = directionalDerivative(work.system);
    if (!(slope > 0.0) || !std::isfinite(longest)) break;
    now = lineSearch(model, state, base, slope, std::min(1.0, longestStep / longest), work);
  }
  work.system.factors.forget();
  return result;
}

}  // namespace perilymph::mechanics
