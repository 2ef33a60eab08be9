// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/foundation/Quantile.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace perilymph {
namespace {

TEST(Quantile, InterpolatesBetweenOrderedValues)
{
  EXPECT_DOUBLE_EQ(quantile({4.0, 1.0, 3.0, 2.0}, 0.5), 2.5);
  EXPECT_DOUBLE_EQ(quantile({4.0, 1.0, 3.0, 2.0}, 0.25), 1.75);
  EXPECT_DOUBLE_EQ(quantile({4.0, 1.0, 3.0, 2.0}, 0.0), 1.0);
  EXPECT_DOUBLE_EQ(quantile({4.0, 1.0, 3.0, 2.0}, 1.0), 4.0);
}

TEST(Quantile, OfOneValueIsThatValueAndOfNoneIsZero)
{
  for (const auto rule : {QuantileRule::ofSample, QuantileRule::predictive}) {
    EXPECT_DOUBLE_EQ(quantile({7.0}, 0.75, rule), 7.0);
    EXPECT_DOUBLE_EQ(quantile({}, 0.75, rule), 0.0);
  }
}

TEST(Quantile, DoesNotDecreaseAndStaysWithinTheValues)
{
  std::mt19937 draw(1);
  std::normal_distribution<double> normal;
  std::vector<double> values(37);
  for (double& value : values) value = normal(draw);
  for (const auto rule : {QuantileRule::ofSample, QuantileRule::predictive}) {
    double last = *std::min_element(values.begin(), values.end());
    for (int percent = 0; percent <= 100; ++percent) {
      const double now = quantile(values, percent / 100.0, rule);
      EXPECT_GE(now, last);
      last = now;
    }
    EXPECT_DOUBLE_EQ(last, *std::max_element(values.begin(), values.end()));
  }
}

TEST(PredictiveQuantile, IsAboveAFurtherValueAsOftenAsItSays)
{
  // of uniform values, the mean of a quantile is the chance that a further value is below it
  std::mt19937 draw(2);
  std::uniform_real_distribution<double> uniform;
  constexpr int trials = 20'000;
  double sum = 0.0;
  for (int trial = 0; trial < trials; ++trial) {
    std::vector<double> values(19);
    for (double& value : values) value = uniform(draw);
    sum += quantile(values, 0.95, QuantileRule::predictive);
  }
  const double deviation = std::sqrt(0.95 * 0.05 / 21.0);  // of the largest of 19
  EXPECT_NEAR(sum / trials, 0.95, 4.0 * deviation / std::sqrt(trials));
}

}  // namespace
}  // namespace perilymph
