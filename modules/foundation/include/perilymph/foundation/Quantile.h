// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Quantiles of a sample.

#include <span>
#include <vector>

namespace perilymph {

/// Which place among n sorted values, counted from 0, is the quantile p.
enum class QuantileRule {
  ofSample,    ///< p (n - 1): the smallest value is the quantile 0, the largest the quantile 1.
  predictive,  ///< p (n + 1) - 1: a further value of the same distribution is below it with p.
};

/// The quantile of values in ascending order, linearly interpolated between two of them and within
/// their range; 0 without any.
double quantileOfSorted(std::span<const double> ascending, double fraction, QuantileRule rule);

/// The quantile of a sample in any order.
double quantile(std::vector<double> values, double fraction,
                QuantileRule rule = QuantileRule::ofSample);

}  // namespace perilymph
