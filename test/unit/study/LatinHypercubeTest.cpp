// SPDX-License-Identifier: BSD-3-Clause
#include "LatinHypercube.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace perilymph::study {
namespace {

constexpr std::size_t samples = 200;

std::vector<double> drawn(std::uint64_t seed, std::uint64_t dimension)
{
  const auto strata = strataOf(seed, dimension, samples);
  std::vector<double> values;
  for (std::size_t i = 0; i < samples; ++i)
    values.push_back(sampleIn(2.0, 4.0, strata[i], samples, seed, dimension, i));
  return values;
}

TEST(LatinHypercube, HasOneSampleInEveryStratumOfEveryDimension)
{
  for (const std::uint64_t dimension : {0, 1, 7}) {
    std::set<int> strata;
    for (const double value : drawn(3, dimension)) {
      EXPECT_GT(value, 2.0);
      EXPECT_LT(value, 4.0);
      strata.insert(static_cast<int>((value - 2.0) / 2.0 * samples));
    }
    EXPECT_EQ(strata.size(), samples);
  }
}

TEST(LatinHypercube, DrawsDimensionsThatDoNotDependOnEachOther)
{
  const auto a = drawn(1, 0), b = drawn(1, 1);
  double covariance = 0.0;
  for (std::size_t i = 0; i < samples; ++i) covariance += (a[i] - 3.0) * (b[i] - 3.0);
  // Variance of a uniform variable of width 2 is 1/3; three standard errors of the correlation.
  EXPECT_LT(std::fabs(covariance / samples * 3.0), 3.0 / std::sqrt(static_cast<double>(samples)));
}

TEST(LatinHypercube, EstimatesAMeanBetterThanIndependentSamples)
{
  // The variance of the mean of x is that of one stratum: 1/12 (2/n)^2 / n.
  const auto values = drawn(5, 0);
  double sum = 0.0;
  for (const double value : values) sum += value;
  const double sd = 2.0 / samples / std::sqrt(12.0 * samples);
  EXPECT_NEAR(sum / samples, 3.0, 5.0 * sd);
}

TEST(LatinHypercube, IsAnotherOneForAnotherSeed) { EXPECT_NE(drawn(1, 0), drawn(2, 0)); }

}  // namespace
}  // namespace perilymph::study
