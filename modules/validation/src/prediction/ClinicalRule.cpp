// SPDX-License-Identifier: BSD-3-Clause
#include "prediction/ClinicalRule.h"

#include <algorithm>
#include <cmath>

#include "perilymph/analysis/SampleStatistics.h"
#include "perilymph/foundation/Math.h"
#include "perilymph/foundation/Normal.h"
#include "perilymph/foundation/Quantile.h"

namespace perilymph::validation {

namespace {

// Of n normal values with the interquartile range Q, the median has the variance (pi / 2) (Q / 1.349)^2
// / n, and ln Q the standard deviation 1.166 / sqrt(n) (David and Nagaraja, Order Statistics, 2003).
constexpr double medianVariance = 0.863;
constexpr double spreadTolerance = 2.29;  // 1.96 times 1.166

double normalBelow(double z) { return 0.5 * std::erfc(-z / std::sqrt(2.0)); }

double squared(double value) { return value * value; }

double interquartileOf(const std::vector<double>& values)
{
  return quantile(values, 0.75) - quantile(values, 0.25);
}

}  // namespace

double expectedRange(int count)
{
  // the integral of 1 - F^n - (1 - F)^n
  constexpr double step = 0.005, end = 9.0;
  double sum = 0.0;
  for (double z = -end; z <= end; z += step) {
    const double below = normalBelow(z);
    sum += 1.0 - std::pow(below, count) - std::pow(1.0 - below, count);
  }
  return sum * step;
}

PooledSample pooled(std::span<const PublishedSample> samples, double between)
{
  PooledSample all;
  double logSum = 0.0, mean = 0.0;
  for (const PublishedSample& each : samples) {
    all.count += each.count;
    mean += each.median / static_cast<double>(samples.size());
    if (!each.interquartile) continue;
    all.spreadCount += each.count;
    logSum += each.count * logarithm(*each.interquartile);
  }
  all.interquartile = exponential(logSum / all.spreadCount);
  double squares = 0.0;
  for (const PublishedSample& each : samples) squares += squared(each.median - mean);
  all.betweenCenters = between;
  if (samples.size() > 1)
    all.betweenCenters =
        std::max(between, std::sqrt(squares / static_cast<double>(samples.size() - 1)));
  double weights = 0.0;
  for (const PublishedSample& each : samples) {
    const double own =
        medianVariance * squared(each.interquartile.value_or(all.interquartile)) / each.count;
    const double weight = 1.0 / (own + squared(all.betweenCenters));
    all.median += weight * each.median;
    weights += weight;
  }
  all.median /= weights;
  all.variance = 1.0 / weights;
  return all;
}

bool Distance::isHit() const noexcept
{
  return std::fabs(difference) <= halfWidth95 * standardError;
}

bool Distance::isHitAtMedian() const noexcept
{
  return std::fabs(atMedian) <= halfWidth95 * atMedianError;
}

bool Distance::isSpreadHit() const noexcept { return std::fabs(spreadRatio) <= spreadTolerance; }

double Distance::power(double error) const noexcept
{
  return normalBelow(error / standardError - halfWidth95);
}

Distance compare(const PooledSample& published, const SimulatedSample& simulated)
{
  const std::vector<double>& x = simulated.values;
  const std::vector<double>& u = simulated.sharedFriction;
  const double n = static_cast<double>(x.size());
  const double meanX = analysis::statisticsOf(x).mean, meanU = analysis::statisticsOf(u).mean;
  double both = 0.0, alone = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    both += (x[i] - meanX) * (u[i] - meanU);
    alone += squared(u[i] - meanU);
  }
  Distance distance;
  if (alone > 0.0) distance.slope = both / alone;
  const double deviation = std::sqrt(alone / (n - 1.0));
  std::vector<double> adjusted(x), atMedian(x);
  for (std::size_t i = 0; i < x.size(); ++i) {
    adjusted[i] -= distance.slope * (u[i] - meanU);
    atMedian[i] -= distance.slope * u[i];
  }
  distance.interquartile = interquartileOf(adjusted);
  const double without = published.variance + medianVariance * squared(distance.interquartile) / n;
  distance.difference = quantile(x, 0.5) - published.median;
  distance.standardError = std::sqrt(without + squared(distance.slope * deviation));
  distance.atMedian = quantile(atMedian, 0.5) - published.median;
  distance.atMedianError = std::sqrt(without);
  distance.spreadRatio = distance.interquartile > 0.0
                             ? logarithm(distance.interquartile / published.interquartile)
                             : -HUGE_VAL;
  distance.spreadTolerance = spreadTolerance * std::sqrt(1.0 / published.spreadCount + 1.0 / n);
  return distance;
}

std::vector<double> binomial(int n, double p)
{
  std::vector<double> probability(static_cast<std::size_t>(n) + 1, 0.0);
  if (!(p > 0.0) || !(p < 1.0)) {
    (p > 0.0 ? probability.back() : probability.front()) = 1.0;
    return probability;
  }
  double log = n * logarithm(1.0 - p);
  const double odds = logarithm(p / (1.0 - p));
  for (int y = 0; y <= n; ++y) {
    probability[static_cast<std::size_t>(y)] = exponential(log);
    log += odds + logarithm((n - y) / (y + 1.0) + (y == n ? 1.0 : 0.0));
  }
  return probability;
}

std::vector<double> betaBinomial(int n, int k, int m)
{
  const double a = k + 0.5, b = m - k + 0.5;
  double log = 0.0;
  for (int i = 0; i < n; ++i) log += logarithm((b + i) / (a + b + i));
  std::vector<double> probability(static_cast<std::size_t>(n) + 1);
  for (int y = 0; y <= n; ++y) {
    probability[static_cast<std::size_t>(y)] = exponential(log);
    if (y < n) log += logarithm((n - y) * (a + y) / ((y + 1.0) * (b + n - y - 1.0)));
  }
  return probability;
}

CountInterval expectedCounts(int n, int k, int m)
{
  const std::vector<double> probability = betaBinomial(n, k, m);
  CountInterval interval{n, 0};
  double below = 0.0;
  for (int y = 0; y <= n; ++y) {
    const double upTo = below + probability[static_cast<std::size_t>(y)];
    // y is inside if neither it and all below, nor it and all above have less than 2.5 %
    if (upTo >= 0.025 && interval.low == n) interval.low = y;
    if (1.0 - below >= 0.025) interval.high = y;
    below = upTo;
  }
  return interval;
}

double CountInterval::power(int n, double p) const
{
  double missed = 0.0;
  const std::vector<double> probability = binomial(n, p);
  for (int y = 0; y <= n; ++y)
    if (!holds(y)) missed += probability[static_cast<std::size_t>(y)];
  return missed;
}

}  // namespace perilymph::validation
