// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/analysis/Tonotopy.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "perilymph/foundation/Math.h"

namespace perilymph::analysis {
namespace {

// Spiral ganglion, a value per quarter turn from 0 to 720 degrees: Stakhovskaya et al. 2007
// (confidence medium: taken from public code that cites them).
constexpr std::array<double, 9> quarterTurns_Hz{17225.0, 6193.0, 3174.0, 1539.0, 785.0,
                                                550.0,   366.0,  215.0,  58.0};

using Values = std::array<double, quarterTurns_Hz.size()>;

bool sameSign(double a, double b) { return a * b > 0.0; }

/// Slope at an end that keeps the curve monotone (Fritsch and Butland 1984), equal steps.
double endSlope(double nearest, double next)
{
  const double slope = 0.5 * (3.0 * nearest - next);
  if (!sameSign(slope, nearest)) return 0.0;
  if (!sameSign(nearest, next) && std::fabs(slope) > 3.0 * std::fabs(nearest)) return 3.0 * nearest;
  return slope;
}

/// Slopes per step: harmonic means of the neighbors' differences, 0 where they change sign.
Values monotoneSlopes(const Values& y)
{
  Values slopes{};
  const std::size_t last = y.size() - 1;
  for (std::size_t i = 1; i < last; ++i) {
    const double before = y[i] - y[i - 1];
    const double after = y[i + 1] - y[i];
    if (sameSign(before, after)) slopes[i] = 2.0 * before * after / (before + after);
  }
  slopes[0] = endSlope(y[1] - y[0], y[2] - y[1]);
  slopes[last] = endSlope(y[last] - y[last - 1], y[last - 1] - y[last - 2]);
  return slopes;
}

}  // namespace

double greenwoodFrequency(double fromApex)
{
  return 165.4 * (power(10.0, 2.1 * std::clamp(fromApex, 0.0, 1.0)) - 0.88);
}

double spiralGanglionFrequency(Angle angle)
{
  Values y{};
  for (std::size_t i = 0; i < y.size(); ++i) y[i] = logarithm(quarterTurns_Hz[i]);
  const Values slopes = monotoneSlopes(y);

  const double index = std::clamp(inDegrees(angle) / 90.0, 0.0, static_cast<double>(y.size() - 1));
  const std::size_t i = std::min(static_cast<std::size_t>(index), y.size() - 2);
  const double x = index - static_cast<double>(i);
  const double rest = 1.0 - x;
  // cubic through both values with both slopes (Hermite)
  return exponential(y[i] * rest * rest * (1.0 + 2.0 * x) + slopes[i] * x * rest * rest +
                     y[i + 1] * x * x * (3.0 - 2.0 * x) - slopes[i + 1] * x * x * rest);
}

double semitones(double from_Hz, double to_Hz)
{
  return 12.0 * (logarithm(to_Hz) - logarithm(from_Hz)) / logarithm(2.0);
}

}  // namespace perilymph::analysis
