// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/device/ScriptedDevice.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

namespace perilymph::device {
namespace {

constexpr double speed = 2e-3;
constexpr double timeStep = 1e-3;

TEST(ScriptedDevice, MovesIntoTheCochleaAtItsSpeedOnceItHolds)
{
  ScriptedDevice hand(speed, timeStep);
  hand.move(ScriptedDevice::Motion::insert);
  EXPECT_EQ(hand.read().position_D[2], 0.0);  // takes hold
  DeviceSample sample;
  for (int i = 0; i < 1000; ++i) sample = hand.read();
  EXPECT_NEAR(sample.position_D[2], -speed * 1000 * timeStep, 1e-15);
  EXPECT_EQ(sample.buttons, graspButton);
}

TEST(ScriptedDevice, ReturnsOnTheSamePath)
{
  ScriptedDevice hand(speed, timeStep);
  hand.move(ScriptedDevice::Motion::insert);
  for (int i = 0; i < 101; ++i) hand.read();
  hand.move(ScriptedDevice::Motion::withdraw);
  DeviceSample sample;
  for (int i = 0; i < 100; ++i) sample = hand.read();
  EXPECT_NEAR(sample.position_D[2], 0.0, 1e-15);
}

TEST(ScriptedDevice, LetsGoWhileItHolds)
{
  ScriptedDevice hand(speed, timeStep);
  hand.move(ScriptedDevice::Motion::insert);
  hand.read();
  hand.move(ScriptedDevice::Motion::hold);
  const DeviceSample first = hand.read();
  const DeviceSample second = hand.read();
  EXPECT_EQ(first.buttons, 0u);
  EXPECT_EQ(first.position_D, second.position_D);
}

TEST(ScriptedDevice, IsFreshAndValidAtEveryRead)
{
  ScriptedDevice hand(speed, timeStep);
  std::uint64_t before = hand.read().sequence;
  for (int i = 0; i < 10; ++i) {
    const DeviceSample sample = hand.read();
    EXPECT_EQ(sample.sequence, before + 1);
    EXPECT_EQ(sample.isValid, 1u);
    before = sample.sequence;
  }
}

TEST(ScriptedDevice, StandsStillAtASpeedThatIsNoNumber)
{
  ScriptedDevice hand(speed, timeStep);
  hand.move(ScriptedDevice::Motion::insert);
  hand.read();
  for (const double bad : {std::nan(""), std::numeric_limits<double>::infinity(), -1.0}) {
    hand.setSpeed(bad);
    EXPECT_EQ(hand.read().position_D[2], 0.0) << bad;
  }
}

TEST(ScriptedDevice, RefusesSpeedsAndTimeStepsOutOfRange)
{
  EXPECT_THROW(ScriptedDevice(std::nan(""), timeStep), std::invalid_argument);
  EXPECT_THROW(ScriptedDevice(-1e-3, timeStep), std::invalid_argument);
  EXPECT_THROW(ScriptedDevice(5.0, timeStep), std::invalid_argument);
  EXPECT_THROW(ScriptedDevice(speed, 0.0), std::invalid_argument);
  EXPECT_THROW(ScriptedDevice(speed, 1.0), std::invalid_argument);
}

}  // namespace
}  // namespace perilymph::device
