// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Mean, spread and confidence of repeated measurements.

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "perilymph/foundation/Normal.h"

namespace perilymph::analysis {

/// Statistics of repeated values of one quantity.
struct SampleStatistics {
  double mean = 0.0;
  double standardDeviation = 0.0;  ///< Sample standard deviation, with n - 1; 0 for one value.
  double standardError = 0.0;      ///< Standard error of the mean: standardDeviation / sqrt(n).

  double low95() const { return mean - halfWidth95 * standardError; }
  double high95() const { return mean + halfWidth95 * standardError; }
};

/// Statistics of at least one value; two-pass summation in the given order.
SampleStatistics statisticsOf(std::span<const double> values);

/// Statistics of the difference of two independent means, a - b: variances are added.
SampleStatistics differenceOf(const SampleStatistics& a, const SampleStatistics& b);

/// The rank of each value, from 0; equal values share the mean of theirs.
std::vector<double> ranksOf(std::span<const double> values);

/// Quantile 0.975 of Student's t distribution: half the width of a 95 % interval, in standard errors.
/// Absolute error below 1e-8.
///
/// @param degreesOfFreedom  1 or more, not necessarily whole.
double studentHalfWidth95(double degreesOfFreedom);

/// A value with its 95 % confidence interval.
struct Estimate {
  double value = 0.0, low = 0.0, high = 0.0;
};

/// The 95 % interval of a mean by Student's t; empty for fewer than two values.
std::optional<Estimate> meanWithInterval(std::span<const double> values);

/// The difference of two means with its 95 % interval, for two variances that may differ (Welch,
/// Biometrika 34, 28, 1947).
struct WelchDifference {
  Estimate difference;  ///< a - b
  double degreesOfFreedom = 0.0;
};
/// Empty if one of the samples has fewer than two values, or if neither varies.
std::optional<WelchDifference> welchDifference(std::span<const double> a,
                                               std::span<const double> b);

/// Confidence interval of a proportion (Wilson, J Am Stat Assoc 22, 209, 1927).
Estimate proportionOf(std::size_t hits, std::size_t all);

/// Simulations from which on a share of them is given in percent (choice, high): of fewer, a percent
/// suggests more than was counted, so that n of N is given.
inline constexpr std::size_t fewestForPercent = 30;
/// The hits of a proportion if it is to be given as n of N.
std::optional<std::size_t> countedOf(const Estimate& proportion, std::size_t all);
/// "3 of 16"; from fewestForPercent on, "19 % (11 to 30)" with the interval.
std::string shareText(const Estimate& proportion, std::size_t all);

}  // namespace perilymph::analysis
