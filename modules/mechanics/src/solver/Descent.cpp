// SPDX-License-Identifier: BSD-3-Clause
#include "solver/Descent.h"

#include <algorithm>
#include <cmath>

#include "perilymph/mechanics/advance.h"
#include "solver/NewtonStep.h"

namespace perilymph::mechanics {
namespace {

constexpr int maxTries = 12;            // evaluations per line search
constexpr double longestStep = 0.1e-3;  // maximum displacement of one node in one step [m]
// Maximum slope at the end of a line search, relative to that at its start, of either sign.
constexpr double slopeTolerance = 0.1;

/// The residual after a fraction of the step, with the wall evaluated there.
Residual residualAt(const InsertionModel& model, InsertionState& state, const Base& base,
                    double alpha, RodWorkspace& work) noexcept
{
  moveBy(work.system, alpha, state.position_W);
  std::fill(work.contacts.isKnown.begin(), work.contacts.isKnown.end(),
            static_cast<unsigned char>(0));
  return residual(model, state, base, work);
}

/// A point on the step: its fraction and the directional derivative there [J].
struct Place {
  double alpha;
  double slope;
};

/// Searches along the step, up to the fraction `maxAlpha`, for a point where the slope nearly
/// vanishes.
Residual lineSearch(const InsertionModel& model, InsertionState& state, const Base& base,
                    double start, double maxAlpha, RodWorkspace& work) noexcept
{
  const double enough = slopeTolerance * start;
  Place low{0.0, start};
  Place high{maxAlpha, 0.0};
  Residual there = residualAt(model, state, base, maxAlpha, work);
  high.slope = directionalDerivativeAt(work.system, maxAlpha);
  // Illinois method: regula falsi that halves the weight of a retained end
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
