// SPDX-License-Identifier: BSD-3-Clause
#include "validation/GaussNewton2.h"

#include <algorithm>
#include <cmath>

namespace perilymph::analysis {

namespace {

constexpr int maxRounds = 10;
constexpr double stepTolerance = 0.02;  // of a step: below all uncertainties
constexpr double negligible = 1e-6;     // of the cost

double costOf(const TwoNumbers& residual)
{
  return residual.a * residual.a + residual.b * residual.b;
}

/// Grid points, equally spaced between the bounds and half a spacing off them.
std::vector<TwoNumbers> rasterOf(const TwoBounds& bounds)
{
  std::vector<TwoNumbers> places;
  if (bounds.raster < 2) return places;
  for (int i = 0; i < bounds.raster; ++i)
    for (int j = 0; j < bounds.raster; ++j) {
      const double fractionA = (i + 0.5) / bounds.raster;
      const double fractionB = (j + 0.5) / bounds.raster;
      places.push_back({bounds.low.a + fractionA * (bounds.high.a - bounds.low.a),
                        bounds.low.b + fractionB * (bounds.high.b - bounds.low.b)});
    }
  return places;
}

/// Derivatives of the residuals by each unknown, per step.
struct Slopes {
  TwoNumbers byA, byB;
};

TwoNumbers clamped(TwoNumbers at, const TwoBounds& bounds)
{
  return {std::clamp(at.a, bounds.low.a, bounds.high.a),
          std::clamp(at.b, bounds.low.b, bounds.high.b)};
}

/// True for an unknown at a bound that the step would violate.
bool isHeld(double at, double low, double high, double downhill)
{
  return (at <= low && downhill < 0.0) || (at >= high && downhill > 0.0);
}

/// The step direction, in units of `step`; held unknowns do not move.
TwoNumbers direction(const TwoNumbers& at, const TwoNumbers& residual, const Slopes& slopes,
                     const TwoBounds& bounds, double damping)
{
  const double downA = -(slopes.byA.a * residual.a + slopes.byA.b * residual.b);
  const double downB = -(slopes.byB.a * residual.a + slopes.byB.b * residual.b);
  const double aa = costOf(slopes.byA) * (1.0 + damping);
  const double bb = costOf(slopes.byB) * (1.0 + damping);
  const double ab = slopes.byA.a * slopes.byB.a + slopes.byA.b * slopes.byB.b;
  const bool holdsA = isHeld(at.a, bounds.low.a, bounds.high.a, downA) || !(aa > 0.0);
  const bool holdsB = isHeld(at.b, bounds.low.b, bounds.high.b, downB) || !(bb > 0.0);
  const double determinant = aa * bb - ab * ab;
  if (!holdsA && !holdsB && determinant > 0.0)
    return {(downA * bb - ab * downB) / determinant, (downB * aa - ab * downA) / determinant};
  if (!holdsA) return {downA / aa, 0.0};
  if (!holdsB) return {0.0, downB / bb};
  return {};
}

}  // namespace

Result<GaussNewton2> gaussNewton2(const TwoResiduals& residuals, TwoNumbers start,
                                  const TwoBounds& bounds)
{
  GaussNewton2 fit;
  const auto tried = [&](const TwoNumbers& at) {
    ++fit.trials;
    return residuals(at);
  };
  fit.at = clamped(start, bounds);
  auto first = tried(fit.at);
  if (!first) return first.error();
  fit.residual = *first;
  for (const TwoNumbers& place : rasterOf(bounds)) {
    const auto there = tried(place);
    if (!there) return there.error();
    if (costOf(*there) >= costOf(fit.residual)) continue;
    fit.at = place;
    fit.residual = *there;
  }

  Slopes slopes;
  double damping = 1e-3;
  for (int round = 0; round < maxRounds; ++round) {
    // Finite differences are taken toward the interior of the bounds.
    const double signA = fit.at.a + bounds.step.a > bounds.high.a ? -1.0 : 1.0;
    const double signB = fit.at.b + bounds.step.b > bounds.high.b ? -1.0 : 1.0;
    const auto besideA = tried({fit.at.a + signA * bounds.step.a, fit.at.b});
    if (!besideA) return besideA.error();
    const auto besideB = tried({fit.at.a, fit.at.b + signB * bounds.step.b});
    if (!besideB) return besideB.error();
    slopes.byA = {signA * (besideA->a - fit.residual.a), signA * (besideA->b - fit.residual.b)};
    slopes.byB = {signB * (besideB->a - fit.residual.a), signB * (besideB->b - fit.residual.b)};

    bool hasImproved = false, isConverged = false;
    for (int attempt = 0; attempt < 4 && !hasImproved; ++attempt) {
      const TwoNumbers move = direction(fit.at, fit.residual, slopes, bounds, damping);
      const TwoNumbers next =
          clamped({fit.at.a + move.a * bounds.step.a, fit.at.b + move.b * bounds.step.b}, bounds);
      if (next.a == fit.at.a && next.b == fit.at.b) break;
      const auto there = tried(next);
      if (!there) return there.error();
      hasImproved = costOf(*there) < costOf(fit.residual);
      damping = hasImproved ? std::max(1e-6, 0.1 * damping) : 10.0 * damping;
      if (!hasImproved) continue;
      isConverged = std::fabs(next.a - fit.at.a) < stepTolerance * bounds.step.a &&
                    std::fabs(next.b - fit.at.b) < stepTolerance * bounds.step.b;
      fit.at = next;
      fit.residual = *there;
    }
    if (!hasImproved || isConverged || costOf(fit.residual) < negligible) break;
  }

  // Inverse of the normal matrix of the free unknowns.
  const double aa = costOf(slopes.byA), bb = costOf(slopes.byB);
  const double ab = slopes.byA.a * slopes.byB.a + slopes.byA.b * slopes.byB.b;
  const bool holdsA = fit.at.a <= bounds.low.a || fit.at.a >= bounds.high.a;
  const bool holdsB = fit.at.b <= bounds.low.b || fit.at.b >= bounds.high.b;
  const double determinant = aa * bb - ab * ab;
  if (!holdsA && !holdsB && determinant > 0.0)
    fit.standardDeviation = {bounds.step.a * std::sqrt(bb / determinant),
                             bounds.step.b * std::sqrt(aa / determinant)};
  else if (!holdsA && aa > 0.0)
    fit.standardDeviation.a = bounds.step.a / std::sqrt(aa);
  else if (!holdsB && bb > 0.0)
    fit.standardDeviation.b = bounds.step.b / std::sqrt(bb);
  return fit;
}

}  // namespace perilymph::analysis
