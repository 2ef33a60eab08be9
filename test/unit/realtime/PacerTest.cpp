// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/realtime/Pacer.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace perilymph::realtime {
namespace {

constexpr std::int64_t period = 1'000'000;  // [ns]

TEST(Pacer, KeepsItsGridWhenATickIsALittleLate)
{
  Pacer pacer(milliseconds(1));
  pacer.start(0);
  pacer.begin(period + 300'000);
  EXPECT_EQ(pacer.due(), 2 * period);
  EXPECT_EQ(pacer.lateTicks(), 0u);
}

TEST(Pacer, CountsATickMoreThanOnePeriodLate)
{
  Pacer pacer(milliseconds(1));
  pacer.start(0);
  pacer.begin(period + period);
  EXPECT_EQ(pacer.lateTicks(), 0u);
  pacer.begin(2 * period + period + 1);
  EXPECT_EQ(pacer.lateTicks(), 1u);
  EXPECT_EQ(pacer.missedTicks(), 0u);
}

TEST(Pacer, StartsANewGridAfterALongStallInsteadOfABurst)
{
  Pacer pacer(milliseconds(1));
  pacer.start(0);
  const std::int64_t afterStall = period + 300 * period;
  pacer.begin(afterStall);
  EXPECT_EQ(pacer.due(), afterStall + period);
  EXPECT_EQ(pacer.missedTicks(), 300u);
  EXPECT_EQ(pacer.lateTicks(), 1u);
}

TEST(Pacer, NeverWakesBeforeTheTickIsDue)
{
  Pacer pacer(milliseconds(1));
  pacer.start(monotonicNanoseconds());
  for (int i = 0; i < 20; ++i) {
    const std::int64_t due = pacer.due();
    EXPECT_GE(pacer.wait(), due);
  }
}

TEST(Pacer, ContinuesFromATickThatADeviceStarted)
{
  Pacer pacer(seconds(1e-3));
  pacer.start(0);
  pacer.follow(1'100'000);  // 0.1 ms behind the grid
  EXPECT_EQ(pacer.due(), 2'100'000);
  EXPECT_EQ(pacer.lateTicks(), 0u);
  pacer.follow(3'200'000);  // more than a period behind
  EXPECT_EQ(pacer.due(), 4'200'000);
  EXPECT_EQ(pacer.lateTicks(), 1u);
}

TEST(Pacer, RefusesPeriodsNoLoopCanHave)
{
  for (const double bad : {0.0, -1e-3, 1e-9, 2.0, std::nan("")})
    EXPECT_THROW(Pacer{Duration::fromSi(bad)}, std::invalid_argument) << bad;
}

TEST(MonotonicClock, NeverRunsBackward)
{
  std::int64_t before = monotonicNanoseconds();
  for (int i = 0; i < 10'000; ++i) {
    const std::int64_t now = monotonicNanoseconds();
    ASSERT_GE(now, before);
    before = now;
  }
}

}  // namespace
}  // namespace perilymph::realtime
