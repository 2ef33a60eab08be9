// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/analysis/SampleStatistics.h"

#include <cmath>

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

}  // namespace perilymph::analysis
