// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/analysis/SampleStatistics.h"

#include <algorithm>
#include <cmath>

#include "perilymph/figures/Strings.h"

namespace perilymph::analysis {

SampleStatistics statisticsOf(std::span<const double> values)
{
  SampleStatistics result;
  if (values.empty()) return result;
  const double count = static_cast<double>(values.size());
  for (const double value : values) result.mean += value;
  result.mean /= count;
  if (values.size() == 1) return result;
  double squares = 0.0;
  for (const double value : values) squares += (value - result.mean) * (value - result.mean);
  result.standardDeviation = std::sqrt(squares / (count - 1.0));
  result.standardError = result.standardDeviation / std::sqrt(count);
  return result;
}

SampleStatistics differenceOf(const SampleStatistics& a, const SampleStatistics& b)
{
  SampleStatistics result;
  result.mean = a.mean - b.mean;
  result.standardDeviation = std::sqrt(a.standardDeviation * a.standardDeviation +
                                       b.standardDeviation * b.standardDeviation);
  result.standardError =
      std::sqrt(a.standardError * a.standardError + b.standardError * b.standardError);
  return result;
}

Estimate proportionOf(std::size_t hits, std::size_t all)
{
  if (all == 0) return {0.0, 0.0, 1.0};
  const auto n = static_cast<double>(all);
  const double p = static_cast<double>(hits) / n;
  const double z2 = halfWidth95 * halfWidth95;
  const double middle = (p + z2 / (2.0 * n)) / (1.0 + z2 / n);
  const double half =
      halfWidth95 / (1.0 + z2 / n) * std::sqrt(p * (1.0 - p) / n + z2 / (4.0 * n * n));
  return {p, std::max(middle - half, 0.0), std::min(middle + half, 1.0)};
}

std::optional<std::size_t> countedOf(const Estimate& proportion, std::size_t all)
{
  if (all >= fewestForPercent) return std::nullopt;
  return static_cast<std::size_t>(std::lround(proportion.value * static_cast<double>(all)));
}

std::string shareText(const Estimate& proportion, std::size_t all)
{
  if (const auto count = countedOf(proportion, all))
    return std::to_string(*count) + " of " + std::to_string(all);
  const auto percent = [](double value) { return figures::fixed(100.0 * value, 0); };
  return percent(proportion.value) + " % (" + percent(proportion.low) + " to " +
         percent(proportion.high) + ")";
}

}  // namespace perilymph::analysis
