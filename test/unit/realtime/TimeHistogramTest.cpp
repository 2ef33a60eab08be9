// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/realtime/TimeHistogram.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace perilymph::realtime {
namespace {

TEST(TimeHistogram, GivesZeroWithoutDurations)
{
  const TimeHistogram histogram;
  EXPECT_EQ(histogram.quantile(0.5), 0.0);
  EXPECT_EQ(histogram.longest(), 0.0);
}

TEST(TimeHistogram, GivesQuantilesWithinABinOfTheSortedDurations)
{
  constexpr double bin = 1.0 / 32.0;
  constexpr double rounding = 1e-12;
  std::mt19937_64 random(3);
  std::vector<std::int64_t> durations;
  TimeHistogram histogram;
  for (int i = 0; i < 10'000; ++i) {
    // from nanoseconds to seconds, evenly over the decades
    const double exponent = static_cast<double>(random() % 9000) / 1000.0;
    durations.push_back(static_cast<std::int64_t>(std::pow(10.0, exponent)));
    histogram.add(durations.back());
  }
  std::sort(durations.begin(), durations.end());
  for (const double fraction : {0.01, 0.25, 0.5, 0.9, 0.99, 0.999, 1.0}) {
    const auto rank = static_cast<std::size_t>(std::ceil(fraction * 10'000)) - 1;
    const double exact = static_cast<double>(durations[rank]) * 1e-9;
    EXPECT_GE(histogram.quantile(fraction), exact * (1.0 - rounding)) << fraction;
    EXPECT_LE(histogram.quantile(fraction), exact * (1.0 + bin + rounding)) << fraction;
  }
}

TEST(TimeHistogram, IsExactForTheLongest)
{
  TimeHistogram histogram;
  histogram.add(1'234'567);
  histogram.add(89);
  EXPECT_DOUBLE_EQ(histogram.longest(), 1'234'567e-9);
  EXPECT_DOUBLE_EQ(histogram.quantile(1.0), 1'234'567e-9);
}

TEST(TimeHistogram, TakesDurationsBeyondItsBins)
{
  TimeHistogram histogram;
  histogram.add(-5);
  histogram.add(INT64_MAX);
  EXPECT_EQ(histogram.count(), 2u);
  EXPECT_DOUBLE_EQ(histogram.longest(), static_cast<double>(INT64_MAX) * 1e-9);
  EXPECT_EQ(histogram.quantile(0.5), 0.0);
}

TEST(TimeHistogram, IsEmptyWhenCleared)
{
  TimeHistogram histogram;
  histogram.add(1000);
  histogram.clear();
  EXPECT_EQ(histogram.count(), 0u);
  EXPECT_EQ(histogram.quantile(0.99), 0.0);
}

}  // namespace
}  // namespace perilymph::realtime
