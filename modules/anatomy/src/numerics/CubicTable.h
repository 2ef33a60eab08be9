// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Uniform cubic B-splines: twice continuously differentiable tables, four coefficients per lookup.

#include <cstddef>
#include <vector>

namespace perilymph::anatomy {

/// Weights of the four coefficients around a position in a table, for the value and its derivatives
/// by the index.
struct CubicWeights {
  double value[4];
  double slope[4];
  double bend[4];

  explicit CubicWeights(double f) noexcept
  {
    const double g = 1.0 - f;
    constexpr double sixth = 1.0 / 6.0;
    value[0] = sixth * (g * g * g);
    value[1] = sixth * (4.0 - 6.0 * f * f + 3.0 * f * f * f);
    value[2] = sixth * (4.0 - 6.0 * g * g + 3.0 * g * g * g);
    value[3] = sixth * (f * f * f);
    slope[0] = -0.5 * g * g;
    slope[1] = f * (1.5 * f - 2.0);
    slope[2] = g * (2.0 - 1.5 * g);
    slope[3] = 0.5 * f * f;
    bend[0] = g;
    bend[1] = 3.0 * f - 2.0;
    bend[2] = 3.0 * g - 2.0;
    bend[3] = f;
  }
};

/// Weighted sum of the four coefficients that start at `first`.
inline double weighted(const double* first, const double weights[4]) noexcept
{
  return first[0] * weights[0] + first[1] * weights[1] + first[2] * weights[2] +
         first[3] * weights[3];
}

/// Coefficients (two more than samples) of the interpolating spline, with end slopes estimated from
/// the first and last four samples. At least four samples.
std::vector<double> interpolatingCoefficients(const std::vector<double>& samples);

}  // namespace perilymph::anatomy
