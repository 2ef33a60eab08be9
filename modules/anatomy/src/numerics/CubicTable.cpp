// SPDX-License-Identifier: BSD-3-Clause
#include "numerics/CubicTable.h"

namespace perilymph::anatomy {

std::vector<double> interpolatingCoefficients(const std::vector<double>& samples)
{
  const std::size_t n = samples.size();
  const auto& y = samples;

  // slopes per index at both ends, third-order differences
  const double startSlope = (-11.0 * y[0] + 18.0 * y[1] - 9.0 * y[2] + 2.0 * y[3]) / 6.0;
  const double endSlope =
      (11.0 * y[n - 1] - 18.0 * y[n - 2] + 9.0 * y[n - 3] - 2.0 * y[n - 4]) / 6.0;

  // (c[i-1] + 4 c[i] + c[i+1]) / 6 = y[i], with c[-1] and c[n] eliminated by the end slopes
  std::vector<double> diagonal(n, 4.0), right(n);
  for (std::size_t i = 0; i < n; ++i) right[i] = 6.0 * y[i];
  right[0] += 2.0 * startSlope;
  right[n - 1] -= 2.0 * endSlope;

  // forward elimination; the off-diagonals are 1 except in the modified end rows
  std::vector<double> upper(n, 1.0);
  upper[0] = 2.0;
  for (std::size_t i = 1; i < n; ++i) {
    const double lower = (i == n - 1) ? 2.0 : 1.0;
    const double factor = lower / diagonal[i - 1];
    diagonal[i] -= factor * upper[i - 1];
    right[i] -= factor * right[i - 1];
  }
  std::vector<double> coefficients(n + 2);
  double* c = coefficients.data() + 1;
  c[n - 1] = right[n - 1] / diagonal[n - 1];
  for (std::size_t i = n - 1; i-- > 0;) c[i] = (right[i] - upper[i] * c[i + 1]) / diagonal[i];
  coefficients[0] = c[1] - 2.0 * startSlope;
  coefficients[n + 1] = c[n - 2] + 2.0 * endSlope;
  return coefficients;
}

}  // namespace perilymph::anatomy
