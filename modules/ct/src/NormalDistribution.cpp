// SPDX-License-Identifier: BSD-3-Clause
#include "NormalDistribution.h"

#include <array>
#include <cstddef>

#include "perilymph/foundation/Math.h"

namespace perilymph::ct {
namespace {

constexpr double tableEnd = 6.0, tableStep = 1.0 / 64.0;
constexpr std::size_t tableSize = 2 * 384 + 1;

// Simpson's rule between the entries of a table.
std::array<double, tableSize> integrate()
{
  std::array<double, tableSize> sum{};
  for (std::size_t i = 1; i < tableSize; ++i) {
    const double a = -tableEnd + tableStep * static_cast<double>(i - 1);
    sum[i] = sum[i - 1] + tableStep / 6.0 *
                              (normalDensity(a) + 4.0 * normalDensity(a + 0.5 * tableStep) +
                               normalDensity(a + tableStep));
  }
  return sum;
}

}  // namespace

double normalDensity(double x)
{
  constexpr double inverseRootOfTwoPi = 0.39894228040143268;
  return inverseRootOfTwoPi * exponential(-0.5 * x * x);
}

double normalCumulative(double x)
{
  static const std::array<double, tableSize> table = integrate();
  if (x <= -tableEnd) return 0.0;
  if (x >= tableEnd) return 1.0;
  const double s = (x + tableEnd) / tableStep;
  auto i = static_cast<std::size_t>(s);
  if (i >= tableSize - 1) i = tableSize - 2;
  const double t = s - static_cast<double>(i);
  // Third-order interpolation: the density is the known derivative.
  const double a = -tableEnd + tableStep * static_cast<double>(i);
  const double h = t * tableStep;
  return table[i] + h * normalDensity(a) * (1.0 - h * (0.5 * a - h * (a * a - 1.0) / 6.0));
}

}  // namespace perilymph::ct
