// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The rule of the clinical table: two samples, published and simulated, are compared by the distance
// of their medians. Derivation: guide, clinical.md.

#include <optional>
#include <span>
#include <vector>

namespace perilymph::validation {

/// A published sample of one center.
struct PublishedSample {
  double median = 0.0;
  std::optional<double> interquartile;  ///< Its interquartile range, if published.
  int count = 0;                        ///< Number of patients.
};

/// Expected range of n independent standard normal values, n of at least 2 (Tippett 1925).
double expectedRange(int count);

/// Standard deviation between centers of the same array, in degrees: FLEX28 in two, 575 and 525
/// degrees.
inline constexpr double betweenCenters_deg = 35.0;

/// The median of an array over its centers.
struct PooledSample {
  double median = 0.0;         ///< Weighted by the inverse variances.
  double variance = 0.0;       ///< Variance of that median, differences between centers included.
  double interquartile = 0.0;  ///< Among those that publish it.
  int spreadCount = 0;         ///< Patients of those.
  int count = 0;               ///< Patients of all.
  double betweenCenters = 0.0;
};

/// Pools at least one sample, of which at least one has an interquartile range; the others are given
/// its. Centers differ by `between`, or by what these medians differ if that is more.
PooledSample pooled(std::span<const PublishedSample> samples, double between);

/// Simulated values, and the logarithm of the friction that is common to all ears for each.
struct SimulatedSample {
  std::vector<double> values;
  std::vector<double> sharedFriction;
};

/// A published and a simulated sample compared.
struct Distance {
  double difference = 0.0;     ///< Simulated minus published median.
  double standardError = 0.0;  ///< Standard error of the difference, with the uncertain friction.
  double slope = 0.0;          ///< Change of the values with the shared friction.
  double interquartile = 0.0;  ///< Simulated, without the effect of the shared friction.
  double atMedian = 0.0;       ///< The difference at the median friction.
  double atMedianError = 0.0;  ///< Its standard error.
  double spreadRatio = 0.0;    ///< ln(simulated / published interquartile range).
  double spreadTolerance = 0.0;

  bool isHit() const noexcept;
  bool isHitAtMedian() const noexcept;
  bool isSpreadHit() const noexcept;
  /// Probability of a miss if the simulated median were wrong by `error`.
  double power(double error) const noexcept;
};

/// Needs at least two simulated values.
Distance compare(const PooledSample& published, const SimulatedSample& simulated);

/// Probability of each count 0 to n of n for a proportion p.
std::vector<double> binomial(int n, double p);
/// The same for a proportion that is known from k of m: Beta(k + 1/2, m - k + 1/2).
std::vector<double> betaBinomial(int n, int k, int m);

/// A published count of n compared with k of m simulated ones.
struct CountInterval {
  int low = 0, high = 0;  ///< Published counts that are a hit: 2.5 to 97.5 %.

  bool holds(int count) const noexcept { return count >= low && count <= high; }
  /// Probability of a miss if the proportion of the published sample were p.
  double power(int n, double p) const;
};
CountInterval expectedCounts(int n, int k, int m);

}  // namespace perilymph::validation
