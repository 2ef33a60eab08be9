// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/analysis/SampleStatistics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace perilymph::analysis {
namespace {

TEST(Share, OfFewerThanThirtySimulationsIsACount)
{
  EXPECT_EQ(shareText(proportionOf(3, 16), 16), "3 of 16");
  EXPECT_EQ(shareText(proportionOf(0, 1), 1), "0 of 1");
  EXPECT_EQ(shareText(proportionOf(0, 0), 0), "0 of 0");
  for (std::size_t all = 1; all < 30; ++all)  // what was counted comes back from the fraction
    for (std::size_t hits = 0; hits <= all; ++hits)
      EXPECT_EQ(countedOf(proportionOf(hits, all), all), hits) << hits << " of " << all;
  EXPECT_FALSE(countedOf(proportionOf(3, 30), 30));
  // Wilson: (p + z^2 / 2n -+ z sqrt(p (1 - p) / n + z^2 / 4n^2)) / (1 + z^2 / n)
  EXPECT_EQ(shareText(proportionOf(3, 30), 30), "10 % (3 to 26)");
}

TEST(SampleStatistics, OfTwoFourFourFourFiveFiveSevenNine)
{
  // Mean 5, sum of squared distances 32, n - 1 = 7.
  const std::vector<double> values = {2, 4, 4, 4, 5, 5, 7, 9};
  const SampleStatistics statistics = statisticsOf(values);
  EXPECT_DOUBLE_EQ(statistics.mean, 5.0);
  EXPECT_DOUBLE_EQ(statistics.standardDeviation, std::sqrt(32.0 / 7.0));
  EXPECT_DOUBLE_EQ(statistics.standardError, std::sqrt(32.0 / 7.0 / 8.0));
}

TEST(SampleStatistics, PutsTheConfidenceIntervalAt196StandardErrors)
{
  const SampleStatistics statistics{0.1, 0.02, 0.005};
  EXPECT_DOUBLE_EQ(statistics.low95(), 0.1 - 1.96 * 0.005);
  EXPECT_DOUBLE_EQ(statistics.high95(), 0.1 + 1.96 * 0.005);
}

TEST(SampleStatistics, OfOneValueHasNoSpread)
{
  const std::vector<double> one = {0.3};
  EXPECT_EQ(statisticsOf(one).mean, 0.3);
  EXPECT_EQ(statisticsOf(one).standardDeviation, 0.0);
}

TEST(DifferenceOfMeans, AddsErrorsAsSquares)
{
  const SampleStatistics difference = differenceOf({0.5, 0.3, 0.03}, {0.2, 0.4, 0.04});
  EXPECT_DOUBLE_EQ(difference.mean, 0.3);
  EXPECT_DOUBLE_EQ(difference.standardDeviation, 0.5);
  EXPECT_DOUBLE_EQ(difference.standardError, 0.05);
}

TEST(Proportion, HasTheIntervalOfWilson)
{
  // Newcombe, Stat Med 17, 857, 1998, table I: 81 of 263.
  const Estimate rate = proportionOf(81, 263);
  EXPECT_NEAR(rate.value, 0.3080, 1e-4);
  EXPECT_NEAR(rate.low, 0.2553, 1e-4);
  EXPECT_NEAR(rate.high, 0.3662, 1e-4);
  EXPECT_GT(proportionOf(0, 20).high, 0.1);
  EXPECT_NEAR(proportionOf(0, 20).low, 0.0, 1e-12);
}

TEST(StudentsDistribution, HasTheQuantilesOfTables)
{
  // scipy.stats.t.ppf(0.975, f)
  const std::pair<double, double> quantiles[] = {
      {1.0, 12.706204736432095},  {1.5, 6.016663107990447},  {2.0, 4.302652729911275},
      {4.0, 2.7764451051977987},  {4.5, 2.6589123472044034}, {8.0, 2.3060041350333704},
      {30.0, 2.0422724563012373}, {1e6, 1.9599663568141066}};
  for (const auto& [freedom, quantile] : quantiles)
    EXPECT_NEAR(studentHalfWidth95(freedom), quantile, 1e-8 * quantile) << freedom;
}

TEST(WelchsDifference, NeedsTwoValuesOfEachAndASpread)
{
  const std::vector<double> one = {1.0}, two = {1.0, 2.0}, equal = {3.0, 3.0};
  EXPECT_FALSE(welchDifference(one, two));
  EXPECT_FALSE(welchDifference(equal, equal));
  EXPECT_FALSE(meanWithInterval(one));
  // one sample does not vary: the other alone gives the interval, with its n - 1
  const auto difference = welchDifference(two, equal);
  ASSERT_TRUE(difference);
  EXPECT_NEAR(difference->degreesOfFreedom, 1.0, 1e-12);
  EXPECT_NEAR(difference->difference.high, -1.5 + 12.706204736 * 0.5, 1e-6);
}
}  // namespace
}  // namespace perilymph::analysis
