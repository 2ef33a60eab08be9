// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// A straight line through points, with the interval of its slope and a band.

#include <cstddef>
#include <optional>
#include <span>

#include "perilymph/analysis/SampleStatistics.h"

namespace perilymph::analysis {

/// The line y = a + b x of least squares, for errors of y that are independent and of one variance;
/// intervals by Student's t with n - 2 degrees of freedom (Draper and Smith, Applied Regression
/// Analysis, 3rd edition, 1998, chapter 1).
class LinearTrend {
public:
  std::size_t count() const noexcept { return count_; }
  /// Change of y per unit of x, with its 95 % interval.
  Estimate slope() const;
  double intercept() const { return meanY_ - slope_ * meanX_; }  ///< Value at x = 0.
  /// Standard deviation of the points about the line, with n - 2.
  double residualDeviation() const noexcept { return deviation_; }
  /// The mean of y at x, with its 95 % interval at this x alone.
  Estimate at(double x) const;

private:
  friend std::optional<LinearTrend> linearTrend(std::span<const double>, std::span<const double>);

  std::size_t count_ = 0;
  double meanX_ = 0.0, meanY_ = 0.0, slope_ = 0.0;
  double squaresX_ = 0.0;  ///< Sum of (x - mean)^2.
  double deviation_ = 0.0, quantile_ = 0.0;
};

/// The line through points; `x` and `y` have one value each per point, all finite. Empty for fewer
/// than three points, or if x does not vary.
std::optional<LinearTrend> linearTrend(std::span<const double> x, std::span<const double> y);

}  // namespace perilymph::analysis
