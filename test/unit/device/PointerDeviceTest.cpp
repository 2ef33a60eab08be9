// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/device/PointerDevice.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "perilymph/foundation/Units.h"

namespace perilymph::device {
namespace {

constexpr double timeStep = 1e-3;
constexpr double maxSpeed = 20e-3;       // documented in the header
constexpr double maxAcceleration = 0.4;  // documented in the header
constexpr double rounding = 1e-9;

double distance(const std::array<double, 3>& a, const std::array<double, 3>& b)
{
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

std::array<double, 3> difference(const std::array<double, 3>& a, const std::array<double, 3>& b)
{
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

TEST(PointerDevice, ArrivesWhereTheWindowAskedForIt)
{
  PointerDevice hand(timeStep);
  hand.grasp(true);
  hand.advanceBy(3e-3);
  hand.shiftBy(1e-3, -2e-3);
  DeviceSample sample;
  for (int i = 0; i < 3000; ++i) sample = hand.read();
  EXPECT_NEAR(sample.position_D[0], 1e-3, 1e-9);
  EXPECT_NEAR(sample.position_D[1], -2e-3, 1e-9);
  EXPECT_NEAR(sample.position_D[2], -3e-3, 1e-9);
}

TEST(PointerDevice, DoesNotOvershoot)
{
  PointerDevice hand(timeStep);
  hand.grasp(true);
  hand.advanceBy(5e-3);
  for (int i = 0; i < 3000; ++i) EXPECT_GE(hand.read().position_D[2], -5e-3 - 1e-9);
}

TEST(PointerDevice, LimitsSpeedAndAcceleration)
{
  PointerDevice hand(timeStep);
  hand.grasp(true);
  std::array<double, 3> place = hand.read().position_D;
  std::array<double, 3> step{};
  for (int i = 0; i < 4000; ++i) {
    if (i % 400 == 0) hand.advanceBy(i % 800 == 0 ? 0.05 : -0.1);
    if (i % 300 == 0) hand.shiftBy(0.03, -0.04);
    if (i == 2000) hand.grasp(false);
    if (i == 2100) hand.grasp(true);
    const std::array<double, 3> next = hand.read().position_D;
    const std::array<double, 3> nextStep = difference(next, place);
    EXPECT_LE(distance(next, place), maxSpeed * timeStep * (1.0 + rounding)) << i;
    EXPECT_LE(distance(nextStep, step),
              maxAcceleration * timeStep * timeStep * (1.0 + rounding) + 1e-15)
        << i;
    place = next;
    step = nextStep;
  }
}

TEST(PointerDevice, IgnoresRequestsWhileNotHeld)
{
  PointerDevice hand(timeStep);
  hand.advanceBy(5e-3);
  hand.read();
  hand.grasp(true);
  DeviceSample sample;
  for (int i = 0; i < 1000; ++i) sample = hand.read();
  EXPECT_EQ(sample.position_D[2], 0.0);
}

TEST(PointerDevice, DropsTheRestOfItsMotionWhenReleased)
{
  PointerDevice hand(timeStep);
  hand.grasp(true);
  hand.advanceBy(10e-3);
  for (int i = 0; i < 100; ++i) hand.read();
  hand.grasp(false);
  DeviceSample sample;
  for (int i = 0; i < 1000; ++i) sample = hand.read();
  const double resting = sample.position_D[2];
  EXPECT_GT(resting, -5e-3);
  hand.grasp(true);
  for (int i = 0; i < 1000; ++i) sample = hand.read();
  EXPECT_NEAR(sample.position_D[2], resting, 1e-12);
}

/// Where the array is after four seconds of a drive at 2 mm/s that the window repeats.
double drivenTo(int readsPerCall)
{
  PointerDevice hand(timeStep);
  hand.grasp(true);
  DeviceSample sample;
  for (int i = 0; i < 4000; ++i) {
    if (i % readsPerCall == 0) hand.driveAt(2e-3, 1.0);
    sample = hand.read();
  }
  return -sample.position_D[2];
}

TEST(PointerDevice, IsDrivenAtTheSameSpeedHoweverOftenTheWindowCalls)
{
  EXPECT_NEAR(drivenTo(16), 8e-3, 0.3e-3);  // 0.2 mm behind its target: 2 v / w
  EXPECT_EQ(drivenTo(100), drivenTo(16));
  EXPECT_EQ(drivenTo(1000), drivenTo(16));
}

TEST(PointerDevice, IsDrivenNoFurtherThanAllowed)
{
  PointerDevice hand(timeStep);
  hand.grasp(true);
  hand.driveAt(2e-3, 1e-3);
  DeviceSample sample;
  for (int i = 0; i < 1900; ++i) sample = hand.read();
  EXPECT_NEAR(sample.position_D[2], -1e-3, 1e-9);
}

TEST(PointerDevice, StopsADriveThatTheWindowNoLongerRepeats)
{
  PointerDevice hand(timeStep);
  hand.grasp(true);
  hand.driveAt(2e-3, 1.0);
  DeviceSample sample;
  for (int i = 0; i < 10'000; ++i) sample = hand.read();
  EXPECT_NEAR(sample.position_D[2], -2e-3 * PointerDevice::longestDrive_s, 1e-5);
}

TEST(PointerDevice, StopsADriveWhenLetGo)
{
  PointerDevice hand(timeStep);
  hand.grasp(true);
  hand.driveAt(2e-3, 1.0);
  for (int i = 0; i < 500; ++i) hand.read();
  hand.grasp(false);
  const double released = hand.read().position_D[2];
  DeviceSample sample;
  for (int i = 0; i < 1000; ++i) sample = hand.read();
  EXPECT_NEAR(sample.position_D[2], released, 0.3e-3);  // it brakes
}

TEST(PointerDevice, RollsAboutTheInsertionAxis)
{
  PointerDevice hand(timeStep);
  hand.grasp(true);
  hand.rollBy(degrees(60).si());
  DeviceSample sample;
  for (int i = 0; i < 4000; ++i) sample = hand.read();
  EXPECT_NEAR(sample.rotation_D[0], std::cos(degrees(30).si()), 1e-9);
  EXPECT_NEAR(sample.rotation_D[3], std::sin(degrees(30).si()), 1e-9);
}

TEST(PointerDevice, IgnoresRequestsThatAreNoNumbers)
{
  PointerDevice hand(timeStep);
  hand.grasp(true);
  hand.advanceBy(std::nan(""));
  hand.shiftBy(std::numeric_limits<double>::infinity(), std::nan(""));
  hand.rollBy(-std::numeric_limits<double>::infinity());
  for (int i = 0; i < 10; ++i) hand.read();
  EXPECT_EQ(hand.read().position_D, (std::array<double, 3>{0.0, 0.0, -0.0}));
}

TEST(PointerDevice, RefusesTimeStepsOutOfRange)
{
  for (const double bad : {0.0, -1e-3, 1.0, std::nan("")})
    EXPECT_THROW(PointerDevice{bad}, std::invalid_argument) << bad;
}

}  // namespace
}  // namespace perilymph::device
