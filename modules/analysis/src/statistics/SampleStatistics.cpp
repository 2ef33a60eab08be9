// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/analysis/SampleStatistics.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "perilymph/figures/Strings.h"
#include "perilymph/foundation/Math.h"

namespace perilymph::analysis {

namespace {

/// The beta function B(a, 1/2), relative error below 1e-11: raised to a large a by
/// B(a, 1/2) = B(a + 1, 1/2) (a + 1/2) / a, where the series of Gamma(a + 1/2) / Gamma(a) in 1/a holds.
double betaWithHalf(double a)
{
  double factor = 1.0;
  for (; a < 40.0; a += 1.0) factor *= (a + 0.5) / a;
  const double r = 1.0 / a;
  const double series =
      1.0 + r * (-1.0 / 8 +
                 r * (1.0 / 128 + r * (5.0 / 1024 + r * (-21.0 / 32768 - r * 399.0 / 262144))));
  return factor * std::sqrt(std::numbers::pi / a) / series;
}

/// Student's t distribution.
class StudentDistribution {
public:
  explicit StudentDistribution(double degreesOfFreedom)
      : freedom_(degreesOfFreedom),
        peak_(1.0 / (std::sqrt(freedom_) * betaWithHalf(0.5 * freedom_)))
  {
  }

  double density(double t) const
  {
    return peak_ * exponential(-0.5 * (freedom_ + 1.0) * logarithm(1.0 + t * t / freedom_));
  }
  /// The probability of 0 to t, by Simpson's rule.
  double upTo(double t) const
  {
    constexpr int steps = 2000;  // for one degree of freedom, up to its 12.7: error below 1e-9
    const double step = t / steps;
    double sum = density(0.0) + density(t);
    for (int i = 1; i < steps; ++i) sum += (i % 2 == 1 ? 4.0 : 2.0) * density(i * step);
    return sum * step / 3.0;
  }

private:
  double freedom_, peak_;
};

}  // namespace

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

std::vector<double> ranksOf(std::span<const double> values)
{
  std::vector<std::size_t> order(values.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, {}, [&](std::size_t i) { return values[i]; });
  std::vector<double> ranks(values.size());
  for (std::size_t i = 0; i < order.size();) {
    std::size_t end = i + 1;
    while (end < order.size() && values[order[end]] == values[order[i]]) ++end;
    for (std::size_t k = i; k < end; ++k) ranks[order[k]] = 0.5 * static_cast<double>(i + end - 1);
    i = end;
  }
  return ranks;
}

double studentHalfWidth95(double degreesOfFreedom)
{
  // Newton's iteration from below the root: upTo() is concave, so that it never passes the root.
  const StudentDistribution student(degreesOfFreedom);
  double t = 1.9;
  for (int i = 0; i < 50; ++i) {
    const double step = (0.475 - student.upTo(t)) / student.density(t);
    t += step;
    if (std::fabs(step) < 1e-10) break;
  }
  return t;
}

std::optional<Estimate> meanWithInterval(std::span<const double> values)
{
  if (values.size() < 2) return std::nullopt;
  const SampleStatistics sample = statisticsOf(values);
  const double half =
      studentHalfWidth95(static_cast<double>(values.size() - 1)) * sample.standardError;
  return Estimate{sample.mean, sample.mean - half, sample.mean + half};
}

std::optional<WelchDifference> welchDifference(std::span<const double> a, std::span<const double> b)
{
  if (a.size() < 2 || b.size() < 2) return std::nullopt;
  const SampleStatistics one = statisticsOf(a), other = statisticsOf(b);
  const SampleStatistics both = differenceOf(one, other);
  const double varianceOne = one.standardError * one.standardError;
  const double varianceOther = other.standardError * other.standardError;
  const double variance = varianceOne + varianceOther;
  if (!(variance > 0.0)) return std::nullopt;
  const double freedom = variance * variance /
                         (varianceOne * varianceOne / static_cast<double>(a.size() - 1) +
                          varianceOther * varianceOther / static_cast<double>(b.size() - 1));
  const double half = studentHalfWidth95(freedom) * both.standardError;
  return WelchDifference{{both.mean, both.mean - half, both.mean + half}, freedom};
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
