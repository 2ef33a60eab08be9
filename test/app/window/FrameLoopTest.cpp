// SPDX-License-Identifier: BSD-3-Clause
#include "gui/pages/insert/FrameLoop.h"

#include <gtest/gtest.h>

#include <QTest>

namespace perilymph::test {
namespace {

using gui::ChartPace;

constexpr int timer_ms = 16;

/// Charts drawn by turns of a length during a time.
int chartsDrawn(int turn_ms, int duration_ms)
{
  ChartPace pace;
  int drawn = 0;
  for (int now_ms = 0; now_ms < duration_ms; now_ms += turn_ms)
    if (pace.isDue(now_ms, turn_ms, timer_ms)) {
      pace.drawn(now_ms);
      ++drawn;
    }
  return drawn;
}

TEST(ChartPaceTest, TwoChartsAreDrawnAtMostFifteenTimesASecond)
{
  EXPECT_LE(chartsDrawn(1, 10'000), 10 * 2 * 16);
  EXPECT_GE(chartsDrawn(1, 10'000), 10 * 2 * 14);
}

TEST(ChartPaceTest, ChartsAreDrawnInAlternateFramesOfSixtyASecond)
{
  EXPECT_NEAR(chartsDrawn(timer_ms, 10 * timer_ms * 100), 10 * 100 / 3.0, 10 * 100 / 6.0);
  ChartPace pace;
  ASSERT_TRUE(pace.isDue(0, timer_ms, timer_ms));
  pace.drawn(0);
  EXPECT_FALSE(pace.isDue(timer_ms, timer_ms, timer_ms));
}

TEST(ChartPaceTest, ALateFrameDrawsNoChart)
{
  ChartPace pace;
  pace.drawn(0);
  EXPECT_FALSE(pace.isDue(100, ChartPace::lateTurn_ms + 1, timer_ms));
  EXPECT_TRUE(pace.isDue(100, ChartPace::lateTurn_ms, timer_ms));
}

TEST(ChartPaceTest, WhereEveryFrameIsLateAChartIsDrawnEveryThirdFrameOfTwentyASecond)
{
  EXPECT_NEAR(chartsDrawn(50, 10'000), 10 * 20 / 3.0, 2);
}

TEST(ChartPaceTest, ATimerThatIsSlowAtRestMakesNoFrameLate)
{
  constexpr int resting_ms = 50;
  ChartPace pace;
  pace.drawn(0);
  EXPECT_TRUE(pace.isDue(resting_ms, resting_ms + 2, resting_ms));
}

TEST(FrameLoopTest, CountsAFrameThatIsPassedOnAfterTurnsInWhichNothingChanged)
{
  int turns = 0, pictures = 0;
  gui::FrameLoop loop({[&turns](double) { ++turns; }, [] {},
                       [&turns, &pictures] {
                         pictures += turns == 1;
                         return turns == 1;
                       },
                       [] { return false; }, [] { return true; }},
                      nullptr);
  loop.setInterval(1);
  loop.start();
  ASSERT_TRUE(QTest::qWaitFor([&turns] { return turns > 2; }, 60'000));
  loop.present();
  EXPECT_EQ(pictures, 1);
  EXPECT_EQ(loop.meter().frames(), 1U);
}

}  // namespace
}  // namespace perilymph::test
