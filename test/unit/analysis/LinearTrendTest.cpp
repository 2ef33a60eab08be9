// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/analysis/LinearTrend.h"

#include <gtest/gtest.h>

#include <vector>

namespace perilymph::analysis {
namespace {

TEST(ALinearTrend, HasSlopeAndBandOfScipy)
{
  const std::vector<double> x{8.1, 8.4, 8.9, 9.2, 9.9, 10.3}, y{600, 570, 560, 505, 470, 430};
  const auto trend = linearTrend(x, y);
  ASSERT_TRUE(trend);
  // scipy.stats.linregress and t.ppf(0.975, 4), version 1.10
  EXPECT_NEAR(trend->slope().value, -75.55350553505534, 1e-9);
  EXPECT_NEAR(trend->slope().low, -94.33520449465571, 1e-6);
  EXPECT_NEAR(trend->slope().high, -56.77180657545496, 1e-6);
  EXPECT_NEAR(trend->intercept(), 1212.5553505535054, 1e-8);
  EXPECT_NEAR(trend->residualDeviation(), 12.858780938816597, 1e-9);
  const Estimate beyond = trend->at(11.0);
  EXPECT_NEAR(beyond.value, 381.4667896678967, 1e-8);
  EXPECT_NEAR(beyond.low, 343.498635618224, 1e-6);
  EXPECT_NEAR(beyond.high, 419.4349437175694, 1e-6);
  EXPECT_NEAR(trend->at(9.0).low, 517.785076188486, 1e-6);
}

TEST(ALinearTrend, IsExactForPointsOnALine)
{
  const std::vector<double> x{1.0, 2.0, 4.0, 8.0}, y{1.0, 3.0, 7.0, 15.0};
  const auto trend = linearTrend(x, y);
  ASSERT_TRUE(trend);
  EXPECT_DOUBLE_EQ(trend->slope().low, 2.0);
  EXPECT_DOUBLE_EQ(trend->slope().high, 2.0);
  EXPECT_DOUBLE_EQ(trend->at(0.0).value, -1.0);
}

TEST(ALinearTrend, NeedsThreePointsAndTwoPlaces)
{
  const std::vector<double> two{1.0, 2.0}, same{0.1, 0.1, 0.1, 0.1, 0.1, 0.1}, y{1, 2, 3, 4, 5, 6};
  EXPECT_FALSE(linearTrend(two, two));
  EXPECT_FALSE(linearTrend(same, y));
}

}  // namespace
}  // namespace perilymph::analysis
