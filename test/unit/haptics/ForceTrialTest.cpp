// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/haptics/ForceTrial.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "perilymph/haptics/Snapshot.h"

namespace perilymph::haptics {
namespace {

constexpr double timeStep = 1e-3;

device::DeviceTraits threeAxes()
{
  device::DeviceTraits traits;
  traits.rendersForce = true;
  traits.maxForce = 3.3;
  traits.actuatedTranslations = 3;
  return traits;
}

/// A hand at rest.
class RestingDevice {
public:
  device::DeviceSample next(bool isHeld)
  {
    sample_.isValid = 1;
    ++sample_.sequence;
    sample_.buttons = isHeld ? std::uint32_t{device::graspButton} : 0u;
    return sample_;
  }
  device::DeviceSample silent() const { return sample_; }

private:
  device::DeviceSample sample_;
};

double magnitude(const device::Wrench& wrench_D)
{
  const auto& force = wrench_D.force_D;
  return std::sqrt(force[0] * force[0] + force[1] * force[1] + force[2] * force[2]);
}

TEST(ForceTrial, ShowsEveryAxisAtMostHalfANewton)
{
  ForceTrial trial(threeAxes(), timeStep);
  RestingDevice hand;
  std::array<double, 3> maximum{};
  double maxStep = 0.0, before = 0.0;
  int ticks = 0;
  for (; !trial.isOver() && ticks < 10'000; ++ticks) {
    const device::Wrench wrench_D = trial.step(hand.next(true));
    for (std::size_t i = 0; i < 3; ++i) maximum[i] = std::max(maximum[i], wrench_D.force_D[i]);
    ASSERT_LE(magnitude(wrench_D), 0.5 + 1e-12);
    maxStep = std::max(maxStep, std::abs(magnitude(wrench_D) - before));
    before = magnitude(wrench_D);
  }
  for (const double force : maximum) EXPECT_NEAR(force, 0.5, 0.01);
  EXPECT_LE(ticks, 3100);
  EXPECT_LT(maxStep, 0.01);  // no sudden change
}

TEST(ForceTrial, ShowsAFifthOfAWeakDevicesForce)
{
  device::DeviceTraits traits = threeAxes();
  traits.maxForce = 1.0;
  EXPECT_DOUBLE_EQ(ForceTrial(traits, timeStep).greatest(), 0.2);
}

/// Runs a trial to its end with a hand at a place that does not move.
ForceTrial runAt(const device::DeviceTraits& traits, double distance)
{
  ForceTrial trial(traits, timeStep);
  device::DeviceSample sample;
  sample.isValid = 1;
  sample.buttons = device::graspButton;
  sample.position_D[0] = distance;
  for (int i = 0; i < 10'000 && !trial.isOver(); ++i) {
    ++sample.sequence;
    trial.step(sample);
  }
  return trial;
}

TEST(ForceTrial, KnowsThePeakOfEveryAxis)
{
  const ForceTrial trial = runAt(threeAxes(), 0.0);
  for (std::size_t i = 0; i < 3; ++i) {
    const ForceTrial::Axis& axis = trial.results()[i];
    EXPECT_TRUE(axis.isDone);
    EXPECT_NEAR(axis.peak, 0.5, 0.01);
    EXPECT_EQ(axis.moved, 0.0);
    EXPECT_EQ(axis.limits, 0u);
  }
  for (std::size_t i = 3; i < 6; ++i) EXPECT_FALSE(trial.results()[i].isActuated);
}

TEST(ForceTrial, PushesAPaddleAlongItsOneAxisOnly)
{
  device::DeviceTraits traits = threeAxes();
  traits.actuatedTranslations = 1;
  traits.actuatedAxes = 1u << 2;
  ForceTrial trial(traits, timeStep);
  EXPECT_EQ(trial.axis(), 2);
  RestingDevice hand;
  double peak = 0.0;
  int ticks = 0;
  for (; !trial.isOver() && ticks < 10'000; ++ticks) {
    const device::Wrench wrench_D = trial.step(hand.next(true));
    EXPECT_EQ(wrench_D.force_D[0], 0.0);
    EXPECT_EQ(wrench_D.force_D[1], 0.0);
    peak = std::max(peak, wrench_D.force_D[2]);
  }
  EXPECT_LE(ticks, 1100);
  EXPECT_NEAR(peak, 0.5, 0.01);
  EXPECT_FALSE(trial.results()[0].isActuated);
  EXPECT_TRUE(trial.results()[2].isDone);
}

TEST(ForceTrial, TurnsAboutTheAxesOfADeviceWithTorque)
{
  device::DeviceTraits traits = threeAxes();
  traits.actuatedTranslations = 0;
  traits.actuatedRotations = 1;
  traits.actuatedAxes = 1u << 5;  // about z
  traits.maxTorque = 0.05;        // a fifth is 10 mN.m
  ForceTrial trial(traits, timeStep);
  device::DeviceSample sample;
  sample.isValid = 1;
  sample.buttons = device::graspButton;
  double peak = 0.0, turned = 0.0;
  for (int i = 0; i < 10'000 && !trial.isOver(); ++i) {
    ++sample.sequence;
    turned += 1e-4;
    sample.rotation_D = {std::cos(0.5 * turned), 0.0, 0.0, std::sin(0.5 * turned)};
    const device::Wrench wrench_D = trial.step(sample);
    EXPECT_EQ(magnitude(wrench_D), 0.0);
    peak = std::max(peak, wrench_D.torque_D[2]);
  }
  EXPECT_NEAR(peak, 0.010, 0.0002);
  EXPECT_TRUE(trial.results()[5].isDone);
  EXPECT_NEAR(trial.results()[5].moved, 0.1, 0.002);  // a second at 0.1 rad/s
  for (int i = 0; i < 60; ++i) trial.step(sample);
  EXPECT_EQ(trial.step(sample).torque_D[2], 0.0);
}

TEST(ForceTrial, SaysThatAHandleAtTheEndOfItsReachWasPushedWithNothing)
{
  device::DeviceTraits traits = threeAxes();
  traits.workspaceRadius = 0.08;
  const ForceTrial atTheEnd = runAt(traits, 0.08);
  for (std::size_t i = 0; i < 3; ++i) {
    const ForceTrial::Axis& axis = atTheEnd.results()[i];
    EXPECT_EQ(axis.peak, 0.0);
    EXPECT_NE(axis.limits & nearWorkspaceEnd, 0u);
  }
  const ForceTrial within = runAt(traits, 0.076);
  for (std::size_t i = 0; i < 3; ++i) {
    const ForceTrial::Axis& axis = within.results()[i];
    EXPECT_NEAR(axis.peak, 0.25, 0.01);  // in the middle of the last tenth
    EXPECT_NE(axis.limits & nearWorkspaceEnd, 0u);
  }
}

TEST(ForceTrial, SeesTheHandleMove)
{
  ForceTrial trial(threeAxes(), timeStep);
  device::DeviceSample sample;
  sample.isValid = 1;
  sample.buttons = device::graspButton;
  for (int i = 0; i < 1000; ++i) {
    ++sample.sequence;
    sample.position_D[0] += 2e-6;
    trial.step(sample);
  }
  EXPECT_NEAR(trial.results()[0].moved, 2e-3, 1e-5);
}

/// A handle in a loose hand that pulls it back, which gets the force with a factor: 1, or -1 by a wrong
/// sign. After `letGo` steps the button is let go for 5 ms.
ForceTrial runOn(double factor, int letGo = -1)
{
  constexpr double mass = 0.1, damping = 4.0, stiffness = 40.0;  // [kg], [N.s/m], [N/m]
  ForceTrial trial(threeAxes(), timeStep);
  RestingDevice hand;
  Eigen::Vector3d at_D = Eigen::Vector3d::Zero(), velocity_D = Eigen::Vector3d::Zero();
  for (int i = 0; !trial.isOver(); ++i) {
    device::DeviceSample sample = hand.next(letGo < 0 || i < letGo || i >= letGo + 5);
    for (int axis = 0; axis < 3; ++axis)
      sample.position_D[static_cast<std::size_t>(axis)] += at_D[axis];
    const device::Wrench wrench = trial.step(sample);
    for (int axis = 0; axis < 3; ++axis) {
      const double force = factor * wrench.force_D[static_cast<std::size_t>(axis)];
      velocity_D[axis] +=
          timeStep * (force - damping * velocity_D[axis] - stiffness * at_D[axis]) / mass;
      at_D[axis] += timeStep * velocity_D[axis];
    }
  }
  return trial;
}

TEST(ForceTrial, SeesAForceOfTheWrongSign)
{
  const ForceTrial right = runOn(1.0), wrong = runOn(-1.0);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_GT(right.results()[i].leaned, 1e-3) << i;
    EXPECT_FALSE(right.results()[i].isAgainst) << i;
    EXPECT_LT(wrong.results()[i].leaned, -1e-3) << i;
    EXPECT_TRUE(wrong.results()[i].isAgainst) << i;
  }
}

TEST(ForceTrial, DoesNotTakeAHandleThatSwingsBackForAForceOfTheWrongSign)
{
  for (int letGo = 50; letGo < 1000; letGo += 50) {
    const ForceTrial trial = runOn(1.0, letGo);
    EXPECT_TRUE(trial.isDone());
    EXPECT_FALSE(trial.results()[0].isAgainst) << letGo;
    EXPECT_GT(trial.results()[0].leaned, 1e-3) << letGo;
    EXPECT_TRUE(runOn(-1.0, letGo).results()[0].isAgainst) << letGo;
  }
}

TEST(ForceTrial, ShowsNothingUntilTheButtonIsHeld)
{
  ForceTrial trial(threeAxes(), timeStep);
  RestingDevice hand;
  for (int i = 0; i < 5000; ++i) ASSERT_EQ(magnitude(trial.step(hand.next(false))), 0.0);
  EXPECT_FALSE(trial.isOver());
}

TEST(ForceTrial, EndsThePushWhenTheButtonIsLetGo)
{
  ForceTrial trial(threeAxes(), timeStep);
  RestingDevice hand;
  for (int i = 0; i < 500; ++i) trial.step(hand.next(true));
  double force = 0.5;
  for (int i = 0; i < 60; ++i) {
    const double now = magnitude(trial.step(hand.next(false)));
    ASSERT_LE(now, force);
    force = now;
  }
  EXPECT_EQ(force, 0.0);
  EXPECT_EQ(trial.axis(), 0);  // to be repeated
}

TEST(ForceTrial, EndsThePushWhenTheDeviceFallsSilent)
{
  ForceTrial trial(threeAxes(), timeStep);
  RestingDevice hand;
  for (int i = 0; i < 500; ++i) trial.step(hand.next(true));
  double force = 1.0;
  for (int i = 0; i < 60; ++i) force = magnitude(trial.step(hand.silent()));
  EXPECT_EQ(force, 0.0);
}

TEST(ForceTrial, GivesUpWhenNoPushOfAnAxisIsFinished)
{
  ForceTrial trial(threeAxes(), timeStep);
  RestingDevice hand;
  int ticks = 0;
  for (; !trial.isOver() && ticks < 100'000; ++ticks)
    trial.step(ticks % 600 < 500 ? hand.next(true) : hand.silent());
  EXPECT_NEAR(ticks * timeStep, ForceTrial::patience, 2.0 * timeStep);
  EXPECT_FALSE(trial.isDone());
  EXPECT_GT(trial.results()[0].peak, 0.0);
  EXPECT_FALSE(trial.results()[0].isDone);
  for (int i = 0; i < 60; ++i) trial.step(hand.next(true));
  EXPECT_EQ(magnitude(trial.step(hand.next(true))), 0.0);
}

TEST(ForceTrial, HasItsPatienceForEachAxis)
{
  ForceTrial trial(threeAxes(), timeStep);
  RestingDevice hand;
  for (int axis = 0; axis < 3; ++axis) {
    for (int i = 0; i < 15'000; ++i) trial.step(hand.next(false));
    for (int i = 0; i < 2000 && trial.axis() == axis; ++i) trial.step(hand.next(true));
  }
  EXPECT_TRUE(trial.isDone());
}

TEST(ForceTrial, IsOverAtOnceForADeviceWithoutForce)
{
  EXPECT_TRUE(ForceTrial({}, timeStep).isOver());
}

}  // namespace
}  // namespace perilymph::haptics
