// SPDX-License-Identifier: BSD-3-Clause
#include "NormalDistribution.h"

#include <array>
#include <cstddef>

#include "perilymph/foundation/Math.h"

namespace perilymph::ct {
namespace {

constexpr double last = 6.0, step = 1.0 / 64.0;
constexpr std::size_t count = 2 * 384 + 1;

// Simpson's rule between the entries of a table.
std::array<double, count> integrate()
{
  std::array<double, count> sum{};
  for (std::size_t i = 1; i < count; ++i) {
    const double a = -last + step * static_cast<double>(i - 1);
    sum[i] = sum[i - 1] +
             step / 6.0 *
                 (normalDensity(a) + 4.0 * normalDensity(a + 0.5 * step) + normalDensity(a + step));
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
  static const std::array<double, count> table = integrate();
  if (x <= -last) return 0.0;
  if (x >= last) return 1.0;
  const double s = (x + last) / step;
  auto i = static_cast<std::size_t>(s);
  if (i >= count - 1) i = count - 2;
  const double t = s - static_cast<double>(i);
  // Third-order interpolation: the density is the known derivative.
  const double a = -last + step * static_cast<double>(i);
  const double h = t * step;
  return table[i] + h * normalDensity(a) * (1.0 - h * (0.5 * a - h * (a * a - 1.0) / 6.0));
}

}  // namespace perilymph::ct
