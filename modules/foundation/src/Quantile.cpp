// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/foundation/Quantile.h"

#include <algorithm>
#include <cstddef>

namespace perilymph {

double quantileOfSorted(std::span<const double> ascending, double fraction, QuantileRule rule)
{
  if (ascending.empty()) return 0.0;
  const double last = static_cast<double>(ascending.size()) - 1.0;
  const double wanted =
      rule == QuantileRule::predictive ? fraction * (last + 2.0) - 1.0 : fraction * last;
  const double place = std::clamp(wanted, 0.0, last);
  const auto below = static_cast<std::size_t>(place);
  const double between = place - static_cast<double>(below);
  if (!(between > 0.0)) return ascending[below];
  return ascending[below] + between * (ascending[below + 1] - ascending[below]);
}

double quantile(std::vector<double> values, double fraction, QuantileRule rule)
{
  std::sort(values.begin(), values.end());
  return quantileOfSorted(values, fraction, rule);
}

}  // namespace perilymph
