// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/analysis/RandomStream.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "perilymph/analysis/SampleStatistics.h"

namespace perilymph::analysis {
namespace {

constexpr int many = 100'000;

TEST(RandomStream, IsUniformToWithinFourStandardErrors)
{
  RandomStream random(7, 0, 0);
  std::vector<double> fractions;
  for (int i = 0; i < many; ++i) fractions.push_back(random.uniform());
  const SampleStatistics statistics = statisticsOf(fractions);
  EXPECT_NEAR(statistics.mean, 0.5, 4.0 * std::sqrt(1.0 / 12.0 / many));
  EXPECT_NEAR(statistics.standardDeviation, std::sqrt(1.0 / 12.0), 0.002);
  for (const double fraction : fractions) {
    ASSERT_GT(fraction, 0.0);
    ASSERT_LT(fraction, 1.0);
  }
}

TEST(RandomStream, IsNormalToWithinFourStandardErrors)
{
  RandomStream random(7, 0, 0);
  std::vector<double> deviates;
  double beyondTwo = 0.0;
  for (int i = 0; i < many; ++i) {
    deviates.push_back(random.normal());
    if (std::fabs(deviates.back()) > 2.0) beyondTwo += 1.0;
  }
  const SampleStatistics statistics = statisticsOf(deviates);
  EXPECT_NEAR(statistics.mean, 0.0, 4.0 / std::sqrt(many));
  EXPECT_NEAR(statistics.standardDeviation, 1.0, 4.0 / std::sqrt(2.0 * many));
  // 4.55 % of a normal distribution lie beyond two standard deviations.
  EXPECT_NEAR(beyondTwo / many, 0.0455, 4.0 * std::sqrt(0.0455 * 0.9545 / many));
}

TEST(RandomStream, GivesEveryItemAndPurposeNumbersOfItsOwn)
{
  // Streams of neighboring seeds, items and purposes are not correlated.
  double products = 0.0;
  for (std::uint64_t item = 0; item < many; ++item) {
    RandomStream a(1, item, 0), b(1, item + 1, 0), c(1, item, 1), d(2, item, 0);
    const double first = a.uniform() - 0.5;
    products +=
        first * (b.uniform() - 0.5) + first * (c.uniform() - 0.5) + first * (d.uniform() - 0.5);
  }
  // The variance of one product is 1/144; each item gives three products.
  EXPECT_NEAR(products, 0.0, 4.0 * std::sqrt(3.0 * many / 144.0));
}

TEST(RandomStream, KeepsToItsLimits)
{
  RandomStream random(3, 1, 4);
  for (int i = 0; i < 1000; ++i) {
    const double value = random.normal(0.0, 1.0, -0.5, 0.25);
    EXPECT_GE(value, -0.5);
    EXPECT_LE(value, 0.25);
  }
  EXPECT_EQ(random.normal(0.0, 1e-9, 5.0, 6.0), 5.0);  // outside the limits: the nearer one
}

}  // namespace
}  // namespace perilymph::analysis
