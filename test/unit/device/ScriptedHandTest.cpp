#include "perilymph/device/ScriptedHand.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

namespace perilymph::device {
namespace {

constexpr double speed = 2e-3;
constexpr double timeStep = 1e-3;

TEST(ScriptedHand, MovesIntoTheCochleaAtItsSpeedOnceItHolds)
{
  ScriptedHand hand(speed, timeStep);
  hand.move(ScriptedHand::Motion::insert);
  EXPECT_EQ(hand.read().position_D[2], 0.0);  // takes hold
  DeviceSample sample;
  for (int i = 0; i < 1000; ++i) sample = hand.read();
  EXPECT_NEAR(sample.position_D[2], -speed * 1000 * timeStep, 1e-15);
  EXPECT_EQ(sample.buttons, graspButton);
}

TEST(ScriptedHand, ComesBackTheWayItWent)
{
  ScriptedHand hand(speed, timeStep);
  hand.move(ScriptedHand::Motion::insert);
  for (int i = 0; i < 101; ++i) hand.read();
  hand.move(ScriptedHand::Motion::withdraw);
  DeviceSample sample;
  for (int i = 0; i < 100; ++i) sample = hand.read();
  EXPECT_NEAR(sample.position_D[2], 0.0, 1e-15);
}

TEST(ScriptedHand, LetsGoWhileItHolds)
{
  ScriptedHand hand(speed, timeStep);
  hand.move(ScriptedHand::Motion::insert);
  hand.read();
  hand.move(ScriptedHand::Motion::hold);
  const DeviceSample first = hand.read();
  const DeviceSample second = hand.read();
  EXPECT_EQ(first.buttons, 0u);
  EXPECT_EQ(first.position_D, second.position_D);
}

TEST(ScriptedHand, IsFreshAndValidAtEveryRead)
{
  ScriptedHand hand(speed, timeStep);
  std::uint64_t before = hand.read().sequence;
  for (int i = 0; i < 10; ++i) {
    const DeviceSample sample = hand.read();
    EXPECT_EQ(sample.sequence, before + 1);
    EXPECT_EQ(sample.isValid, 1u);
    before = sample.sequence;
  }
}

TEST(ScriptedHand, StandsStillAtASpeedThatIsNoNumber)
{
  ScriptedHand hand(speed, timeStep);
  hand.move(ScriptedHand::Motion::insert);
  hand.read();
  for (const double bad : {std::nan(""), std::numeric_limits<double>::infinity(), -1.0}) {
    hand.setSpeed(bad);
    EXPECT_EQ(hand.read().position_D[2], 0.0) << bad;
  }
}

TEST(ScriptedHand, RefusesSpeedsAndTimeStepsOutOfRange)
{
  EXPECT_THROW(ScriptedHand(std::nan(""), timeStep), std::invalid_argument);
  EXPECT_THROW(ScriptedHand(-1e-3, timeStep), std::invalid_argument);
  EXPECT_THROW(ScriptedHand(5.0, timeStep), std::invalid_argument);
  EXPECT_THROW(ScriptedHand(speed, 0.0), std::invalid_argument);
  EXPECT_THROW(ScriptedHand(speed, 1.0), std::invalid_argument);
}

}  // namespace
}  // namespace perilymph::device
