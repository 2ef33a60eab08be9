// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/haptics/SampleValidator.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace perilymph::haptics {
namespace {

constexpr double timeStep = 1e-3;

/// Successive fresh samples of a grasping hand.
class Samples {
public:
  device::DeviceSample next(double x = 0.0)
  {
    device::DeviceSample sample;
    sample.sequence = ++sequence_;
    sample.position_D[0] = x;
    sample.buttons = device::graspButton;
    sample.isValid = 1;
    return sample;
  }

private:
  std::uint64_t sequence_ = 0;
};

TEST(SampleValidator, IsStaleUntilTheFirstSample)
{
  SampleValidator validator(timeStep, 1e-3);
  Samples samples;
  EXPECT_TRUE(validator.take(samples.next(std::nan(""))).isStale);
  const HandState& hand = validator.take(samples.next(0.1));
  EXPECT_FALSE(hand.isStale);
  EXPECT_FALSE(hand.hasJumped);
}

TEST(SampleValidator, WaitsThreePeriodsOfTheDeviceButAtLeast3AndAtMost30Milliseconds)
{
  struct Case {
    double period, limit;
  };
  for (const auto& [period, limit] : {Case{1e-4, 3e-3}, Case{1e-3, 3e-3}, Case{4e-3, 12e-3},
                                      Case{8e-3, 24e-3}, Case{0.05, 30e-3}}) {
    SampleValidator validator(timeStep, period);
    Samples samples;
    const device::DeviceSample last = samples.next();
    validator.take(last);
    int silent = 0;
    while (!validator.take(last).isStale) ++silent;
    // stale in the tick that ends the limit
    EXPECT_NEAR((silent + 1) * timeStep, limit, 1e-9) << period;
  }
}

TEST(SampleValidator, TellsTheHandsMotion)
{
  SampleValidator validator(timeStep, 1e-3);
  Samples samples;
  validator.take(samples.next(0.0));
  EXPECT_DOUBLE_EQ(validator.take(samples.next(1e-5)).moved_D.x(), 1e-5);
  for (int i = 2; i < 100; ++i) validator.take(samples.next(1e-5 * i));
  EXPECT_NEAR(validator.take(samples.next(1e-3)).velocity_D.x(), 0.01, 1e-9);
}

TEST(SampleValidator, AcceptsTheMotionAcrossAMissedReport)
{
  SampleValidator validator(timeStep, 1e-3);
  Samples samples;
  const device::DeviceSample first = samples.next(0.0);
  validator.take(first);
  validator.take(first);                                         // one report missed
  const HandState& hand = validator.take(samples.next(1.5e-3));  // 0.75 m/s over two ticks
  EXPECT_FALSE(hand.hasJumped);
  EXPECT_DOUBLE_EQ(hand.moved_D.x(), 1.5e-3);
}

TEST(SampleValidator, RejectsImpossibleValues)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  SampleValidator validator(timeStep, 1e-3);
  Samples samples;
  validator.take(samples.next(0.02));
  for (const double bad : {std::nan(""), infinity, -infinity, 1e300, -11.0}) {
    const HandState& hand = validator.take(samples.next(bad));
    EXPECT_TRUE(hand.isRejected) << bad;
    EXPECT_EQ(hand.position_D.x(), 0.02) << bad;
    EXPECT_EQ(hand.moved_D.norm(), 0.0) << bad;
    validator.take(samples.next(0.02));
  }
  for (const std::array<double, 4>& bad : {std::array<double, 4>{0, 0, 0, 0},
                                           {std::nan(""), 0, 0, 1},
                                           {infinity, 0, 0, 0},
                                           {0.3, 0.3, 0, 0},  // too short to be a rotation
                                           {2, 2, 0, 0},      // too long
                                           {9, 9, 9, 9}}) {
    device::DeviceSample sample = samples.next(0.02);
    sample.rotation_D = bad;
    const HandState& hand = validator.take(sample);
    EXPECT_TRUE(hand.isRejected) << bad[0];
    EXPECT_EQ(hand.rotation_D.w(), 1.0) << bad[0];
  }
}

TEST(SampleValidator, BecomesStaleWithADeviceThatOnlySendsInvalidSamples)
{
  SampleValidator validator(timeStep, 1e-3);
  Samples samples;
  validator.take(samples.next());
  for (int i = 0; i < 3; ++i) validator.take(samples.next(std::nan("")));
  EXPECT_TRUE(validator.take(samples.next(std::nan(""))).isStale);
}

TEST(SampleValidator, TreatsAnUnreachablePositionAsAJump)
{
  SampleValidator validator(timeStep, 1e-3);
  Samples samples;
  validator.take(samples.next(0.0));
  const HandState& hand = validator.take(samples.next(2.0));  // 2 m in a tick
  EXPECT_TRUE(hand.hasJumped);
  EXPECT_EQ(hand.moved_D.norm(), 0.0);
  EXPECT_FALSE(validator.take(samples.next(2.0)).hasJumped);
}

TEST(SampleValidator, TreatsAnImpossibleRotationAsAJump)
{
  SampleValidator validator(timeStep, 1e-3);
  Samples samples;
  validator.take(samples.next());
  device::DeviceSample turned = samples.next();
  turned.rotation_D = {0.0, 1.0, 0.0, 0.0};
  EXPECT_TRUE(validator.take(turned).hasJumped);
  // minus the same quaternion is the same rotation
  turned = samples.next();
  turned.rotation_D = {0.0, -1.0, 0.0, 0.0};
  EXPECT_FALSE(validator.take(turned).hasJumped);
}

TEST(SampleValidator, TreatsTheFirstPositionAfterSilenceAsAJump)
{
  SampleValidator validator(timeStep, 1e-3);
  Samples samples;
  const device::DeviceSample last = samples.next(0.0);
  for (int i = 0; i < 10; ++i) validator.take(last);
  const HandState& hand = validator.take(samples.next(1e-4));
  EXPECT_TRUE(hand.hasJumped);
  EXPECT_FALSE(hand.isStale);
}

TEST(SampleValidator, AcceptsAReleaseFromARejectedSample)
{
  SampleValidator validator(timeStep, 1e-3);
  Samples samples;
  ASSERT_TRUE(validator.take(samples.next()).isHeld);
  device::DeviceSample rejected = samples.next(std::nan(""));
  EXPECT_TRUE(validator.take(rejected).isHeld);
  rejected.buttons = 0;
  EXPECT_FALSE(validator.take(rejected).isHeld);
  // but not a press
  rejected = samples.next(std::nan(""));
  EXPECT_FALSE(validator.take(rejected).isHeld);
}

TEST(SampleValidator, HoldsNothingOnceTheDeviceIsLost)
{
  SampleValidator validator(timeStep, 1e-3);
  Samples samples;
  validator.take(samples.next());
  device::DeviceSample lost = samples.next();
  lost.isValid = 0;
  const HandState& hand = validator.take(lost);
  EXPECT_TRUE(hand.isLost);
  EXPECT_FALSE(hand.isHeld);
}

}  // namespace
}  // namespace perilymph::haptics
