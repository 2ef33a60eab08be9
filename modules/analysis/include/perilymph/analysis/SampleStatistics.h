#pragma once

// Mean, spread and confidence of repeated measurements.

#include <span>

namespace perilymph::analysis {

/// Half the width of a 95 % confidence interval in standard errors, of a normal distribution.
inline constexpr double halfWidth95 = 1.96;

/// What repeated values of one quantity say about it.
struct SampleStatistics {
  double mean = 0.0;
  double standardDeviation =
      0.0;                     ///< Standard deviation of the sample, with n - 1; 0 for one value.
  double standardError = 0.0;  ///< Standard error of the mean: standardDeviation / sqrt(n).

  double low95() const { return mean - halfWidth95 * standardError; }
  double high95() const { return mean + halfWidth95 * standardError; }
};

/// Statistics of at least one value; sums in their order, twice over (mean first).
SampleStatistics statisticsOf(std::span<const double> values);

/// Statistics of the difference of two independent means, a - b: variances add up.
SampleStatistics differenceOf(const SampleStatistics& a, const SampleStatistics& b);

}  // namespace perilymph::analysis
