// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/analysis/LinearTrend.h"

#include <algorithm>
#include <cmath>

namespace perilymph::analysis {

Estimate LinearTrend::slope() const
{
  const double half = quantile_ * deviation_ / std::sqrt(squaresX_);
  return {slope_, slope_ - half, slope_ + half};
}

Estimate LinearTrend::at(double x) const
{
  const double value = meanY_ + slope_ * (x - meanX_);
  const double half =
      quantile_ * deviation_ *
      std::sqrt(1.0 / static_cast<double>(count_) + (x - meanX_) * (x - meanX_) / squaresX_);
  return {value, value - half, value + half};
}

std::optional<LinearTrend> linearTrend(std::span<const double> x, std::span<const double> y)
{
  LinearTrend trend;
  trend.count_ = std::min(x.size(), y.size());
  if (trend.count_ < 3) return std::nullopt;
  trend.meanX_ = statisticsOf(x.first(trend.count_)).mean;
  trend.meanY_ = statisticsOf(y.first(trend.count_)).mean;
  double products = 0.0;
  for (std::size_t i = 0; i < trend.count_; ++i) {
    trend.squaresX_ += (x[i] - trend.meanX_) * (x[i] - trend.meanX_);
    products += (x[i] - trend.meanX_) * (y[i] - trend.meanY_);
  }
  // equal values of x, or all but equal: their mean is rounded
  const double rounding = 1e-12 * std::max(1.0, std::fabs(trend.meanX_));
  if (!(trend.squaresX_ > static_cast<double>(trend.count_) * rounding * rounding))
    return std::nullopt;
  trend.slope_ = products / trend.squaresX_;
  double squares = 0.0;
  for (std::size_t i = 0; i < trend.count_; ++i) {
    const double residual = y[i] - trend.meanY_ - trend.slope_ * (x[i] - trend.meanX_);
    squares += residual * residual;
  }
  const double freedom = static_cast<double>(trend.count_ - 2);
  trend.deviation_ = std::sqrt(squares / freedom);
  trend.quantile_ = studentHalfWidth95(freedom);
  return trend;
}

}  // namespace perilymph::analysis
