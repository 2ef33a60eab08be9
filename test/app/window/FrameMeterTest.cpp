// SPDX-License-Identifier: BSD-3-Clause
#include "gui/pages/insert/FrameMeter.h"

#include <gtest/gtest.h>

namespace perilymph::test {
namespace {

using gui::FrameMeter;
using std::chrono::milliseconds;

/// Frames every 20 ms that take 1, 2, ... `count` milliseconds.
FrameMeter measured(int count)
{
  FrameMeter meter;
  FrameMeter::Clock::time_point now{};
  for (int i = 1; i <= count; ++i) {
    meter.begin(now);
    meter.present(now + milliseconds(i));
    now += milliseconds(20);
  }
  return meter;
}

TEST(FrameTimes, MedianAndP95AreThoseOfTheFrames)
{
  const FrameMeter meter = measured(100);
  EXPECT_DOUBLE_EQ(meter.quantile_ms(0.5), 50.5);  // between 50 and 51 of 1 to 100
  EXPECT_DOUBLE_EQ(meter.quantile_ms(0.95), 95.05);
}

TEST(FrameTimes, AWindowThatIsPassedOnWithoutANewPictureIsNoFrame)
{
  FrameMeter meter;
  meter.present(FrameMeter::Clock::time_point{} + milliseconds(5));
  EXPECT_EQ(meter.frames(), 0u);
}

TEST(FrameTimes, OneFramePresentedTwiceCountsOnce)
{
  FrameMeter meter;
  meter.begin({});
  meter.present(FrameMeter::Clock::time_point{} + milliseconds(5));
  meter.present(FrameMeter::Clock::time_point{} + milliseconds(6));
  EXPECT_EQ(meter.frames(), 1u);
}

TEST(FrameTimes, FramesPerSecondAreThoseOfTheLastSecond)
{
  FrameMeter meter;
  FrameMeter::Clock::time_point now{};
  for (int i = 0; i < 100; ++i) {  // two seconds at 50 Hz
    now += milliseconds(20);
    meter.begin(now);
    meter.present(now);
  }
  EXPECT_EQ(meter.framesPerSecond(now), 50);
  EXPECT_EQ(meter.framesPerSecond(now + std::chrono::seconds(2)), 0);
}

TEST(FrameTimes, WithoutFramesNothingIsClaimed)
{
  EXPECT_DOUBLE_EQ(FrameMeter().quantile_ms(0.95), 0.0);
}

}  // namespace
}  // namespace perilymph::test
