// SPDX-License-Identifier: BSD-3-Clause

// The rule of the clinical table against closed forms and against its own promise of 95 %.

#include "prediction/ClinicalRule.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <random>

#include "perilymph/foundation/Quantile.h"

namespace perilymph::validation {
namespace {

TEST(ExpectedRange, IsThatOfTables)
{
  // d2 of control charts (Tippett 1925)
  EXPECT_NEAR(expectedRange(2), 2.0 / std::sqrt(std::acos(-1.0)), 1e-6);
  EXPECT_NEAR(expectedRange(10), 3.07751, 1e-5);
  EXPECT_NEAR(expectedRange(25), 3.93063, 1e-5);
}

TEST(PooledSample, OfOneCenterIsThatCenter)
{
  const std::vector<PublishedSample> one = {{408.0, 76.0, 16}};
  const PooledSample pool = pooled(one, 35.0);
  EXPECT_DOUBLE_EQ(pool.median, 408.0);
  EXPECT_NEAR(pool.interquartile, 76.0, 1e-12);
  EXPECT_NEAR(pool.variance, 0.863 * 76.0 * 76.0 / 16.0 + 35.0 * 35.0, 1e-9);
  EXPECT_EQ(pool.count, 16);
}

TEST(PooledSample, TakesTheLargerDifferenceBetweenCenters)
{
  // equally large centers: the mean, with half of the variance of each
  const std::vector<PublishedSample> two = {{641.0, 66.0, 40}, {489.0, std::nullopt, 40}};
  const PooledSample pool = pooled(two, 35.0);
  EXPECT_NEAR(pool.betweenCenters, 152.0 / std::sqrt(2.0), 1e-9);
  EXPECT_NEAR(pool.median, 565.0, 1e-9);
  EXPECT_NEAR(pool.variance, 0.5 * (0.863 * 66.0 * 66.0 / 40.0 + 152.0 * 152.0 / 2.0), 1e-6);
  EXPECT_EQ(pool.spreadCount, 40);
  EXPECT_EQ(pool.count, 80);
}

TEST(Distance, SeparatesTheFrictionThatAllEarsShare)
{
  // values 0 to 8 with a part of 50 for each unit of the friction, which is independent of them
  SimulatedSample simulated;
  for (int i = 0; i < 9; ++i)
    for (const double friction : {-0.3, 0.3}) {
      simulated.values.push_back(400.0 + i + 50.0 * friction);
      simulated.sharedFriction.push_back(friction);
    }
  const PooledSample published{404.0, 100.0, 20.0, 16, 16, 0.0};
  const Distance distance = compare(published, simulated);
  EXPECT_NEAR(distance.slope, 50.0, 1e-9);
  EXPECT_NEAR(distance.difference, 0.0, 1e-9);
  EXPECT_NEAR(distance.interquartile, 4.0, 0.5);  // of 0 to 8, each twice
  const double without = 100.0 + 0.863 * std::pow(distance.interquartile, 2) / 18.0;
  EXPECT_NEAR(distance.atMedianError, std::sqrt(without), 1e-9);
  const double friction = 0.3 * std::sqrt(18.0 / 17.0);  // sample standard deviation
  EXPECT_NEAR(distance.standardError, std::sqrt(without + std::pow(50.0 * friction, 2)), 1e-9);
  EXPECT_NEAR(distance.power(2.96 * distance.standardError), 0.841345, 1e-6);  // Phi(1)
}

/// The promise of the rule: a right model is hit in 95 of 100 comparisons.
TEST(Distance, IsAHitOfARightModelInNinetyFivePercent)
{
  std::mt19937 random(7);
  std::normal_distribution<double> normal;
  constexpr double between = 35.0, deviation = 60.0, slope = -150.0, shared = 0.28;
  int hits = 0, spreads = 0;
  constexpr int comparisons = 4000;
  for (int number = 0; number < comparisons; ++number) {
    const double truth = 500.0 + slope * shared * normal(random) + between * normal(random);
    std::vector<double> clinic(20);
    for (double& value : clinic) value = truth + deviation * normal(random);
    SimulatedSample simulated;
    for (int i = 0; i < 72; ++i) {
      const double friction = shared * normal(random);
      simulated.sharedFriction.push_back(friction);
      simulated.values.push_back(500.0 + slope * friction + deviation * normal(random));
    }
    const double width = quantile(clinic, 0.75) - quantile(clinic, 0.25);
    const std::vector<PublishedSample> published = {{quantile(clinic, 0.5), width, 20}};
    const Distance distance = compare(pooled(published, between), simulated);
    hits += distance.isHit() ? 1 : 0;
    spreads += distance.isSpreadHit() ? 1 : 0;
  }
  EXPECT_NEAR(hits / static_cast<double>(comparisons), 0.95, 0.015);
  EXPECT_NEAR(spreads / static_cast<double>(comparisons), 0.95, 0.02);
}

TEST(Distance, FindsAWrongModelAsOftenAsItsPowerSays)
{
  std::mt19937 random(8);
  std::normal_distribution<double> normal;
  int misses = 0;
  double power = 0.0;
  constexpr int comparisons = 2000;
  for (int number = 0; number < comparisons; ++number) {
    std::vector<double> clinic(16);
    const double center = 35.0 * normal(random);
    for (double& value : clinic) value = center + 60.0 * normal(random);
    SimulatedSample simulated;
    for (int i = 0; i < 60; ++i) {
      simulated.sharedFriction.push_back(0.0);
      simulated.values.push_back(100.0 + 60.0 * normal(random));
    }
    const double width = quantile(clinic, 0.75) - quantile(clinic, 0.25);
    const std::vector<PublishedSample> published = {{quantile(clinic, 0.5), width, 16}};
    const Distance distance = compare(pooled(published, 35.0), simulated);
    misses += distance.isHit() ? 0 : 1;
    power += distance.power(100.0) / comparisons;
  }
  EXPECT_NEAR(misses / static_cast<double>(comparisons), power, 0.03);
}

TEST(Binomial, IsItsClosedForm)
{
  const std::vector<double> four = binomial(4, 0.5);
  ASSERT_EQ(four.size(), 5u);
  EXPECT_NEAR(four[0], 1.0 / 16.0, 1e-12);
  EXPECT_NEAR(four[2], 6.0 / 16.0, 1e-12);
  EXPECT_NEAR(four[4], 1.0 / 16.0, 1e-12);
  EXPECT_EQ(binomial(3, 0.0), (std::vector<double>{1.0, 0.0, 0.0, 0.0}));
  EXPECT_EQ(binomial(3, 1.0), (std::vector<double>{0.0, 0.0, 0.0, 1.0}));
}

TEST(BetaBinomial, IsItsClosedForm)
{
  // without a simulation, Beta(1/2, 1/2): 3/8, 2/8, 3/8
  const std::vector<double> two = betaBinomial(2, 0, 0);
  ASSERT_EQ(two.size(), 3u);
  EXPECT_NEAR(two[0], 0.375, 1e-12);
  EXPECT_NEAR(two[1], 0.25, 1e-12);
  EXPECT_NEAR(two[2], 0.375, 1e-12);
  // mean n a / (a + b), variance n a b (a + b + n) / ((a + b)^2 (a + b + 1))
  const std::vector<double> many = betaBinomial(507, 3, 360);
  const double a = 3.5, b = 357.5, n = 507.0;
  double sum = 0.0, mean = 0.0, square = 0.0;
  for (std::size_t y = 0; y < many.size(); ++y) {
    const double count = static_cast<double>(y);
    sum += many[y];
    mean += count * many[y];
    square += count * count * many[y];
  }
  EXPECT_NEAR(sum, 1.0, 1e-10);
  EXPECT_NEAR(mean, n * a / (a + b), 1e-8);
  EXPECT_NEAR(square - mean * mean, n * a * b * (a + b + n) / ((a + b) * (a + b) * (a + b + 1.0)),
              1e-7);
}

TEST(ExpectedCounts, AreTheBinomialsOfARateThatIsKnownWell)
{
  // 20 with 0.5: 6 to 14 (2.1 % below 6, 5.8 % up to 6)
  const CountInterval coins = expectedCounts(20, 500'000, 1'000'000);
  EXPECT_EQ(coins.low, 6);
  EXPECT_EQ(coins.high, 14);
  EXPECT_TRUE(coins.holds(6));
  EXPECT_FALSE(coins.holds(5));
  // P(X < 6) + P(X > 14) for 20 with 0.3, by sums of its closed form
  EXPECT_NEAR(coins.power(20, 0.3), 0.416371 + 0.000043, 1e-5);
}

TEST(ExpectedCounts, DoNotHoldOneClinicsCasesWhereNoneWasSimulated)
{
  EXPECT_FALSE(expectedCounts(507, 0, 360).holds(43));
  EXPECT_TRUE(expectedCounts(507, 0, 360).holds(0));
  EXPECT_TRUE(expectedCounts(51, 0, 0).holds(49));  // nothing simulated, nothing known
}

}  // namespace
}  // namespace perilymph::validation
