// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/haptics/Safety.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "perilymph/haptics/Snapshot.h"

namespace perilymph::haptics {
namespace {

constexpr double tick_s = 1e-3;
constexpr double tolerance = 1e-12;

HandCondition holding()
{
  HandCondition hand;
  hand.isHeld = true;
  return hand;
}

/// A safety chain after fading in, with the force `force`.
Safety shownFor(const Eigen::Vector3d& force_D, SafetyLimits limits = {})
{
  Safety safety(limits, tick_s);
  std::uint32_t status = 0;
  for (int i = 0; i < 1000; ++i) safety.show(force_D, holding(), status);
  return safety;
}

TEST(Safety, ShowsAHarmlessForceAsItIs)
{
  const Eigen::Vector3d force_D(0.05, -0.02, 0.1);
  Safety safety = shownFor(force_D);
  std::uint32_t status = allWell;
  EXPECT_EQ(safety.show(force_D, holding(), status), force_D);
  EXPECT_EQ(status, allWell);
}

TEST(Safety, ClampsTheMagnitudeAndKeepsTheDirection)
{
  const Eigen::Vector3d wanted_D(30.0, -40.0, 0.0);
  Safety safety = shownFor(wanted_D);
  std::uint32_t status = allWell;
  const Eigen::Vector3d shown_D = safety.show(wanted_D, holding(), status);
  EXPECT_NEAR(shown_D.norm(), 3.3, tolerance);
  EXPECT_NEAR(shown_D.x() / shown_D.y(), -0.75, tolerance);
  EXPECT_NE(status & forceClamped, 0u);
}

TEST(Safety, ClampsForcesWhoseSquareOverflows)
{
  Safety safety = shownFor({1e300, 1e300, -1e300});
  std::uint32_t status = allWell;
  const Eigen::Vector3d shown_D = safety.show({1e300, 1e300, -1e300}, holding(), status);
  EXPECT_NEAR(shown_D.norm(), 3.3, tolerance);
}

TEST(Safety, TakesAForceThatIsNoNumberAsNone)
{
  for (const double bad : {std::nan(""), std::numeric_limits<double>::infinity()}) {
    Safety safety = shownFor({0.05, 0.0, 0.0});
    std::uint32_t status = allWell;
    EXPECT_EQ(safety.show({0.1, bad, 0.0}, holding(), status), Eigen::Vector3d::Zero()) << bad;
  }
}

TEST(Safety, TakesAForceOfWhichOneComponentIsNoNumberAsNone)
{
  for (int axis = 0; axis < 3; ++axis) {
    Safety safety = shownFor({0.05, 0.0, 0.0});
    Eigen::Vector3d wanted_D(0.1, 0.1, 0.1);
    wanted_D[axis] = std::nan("");
    std::uint32_t status = allWell;
    EXPECT_EQ(safety.show(wanted_D, holding(), status), Eigen::Vector3d::Zero()) << axis;
  }
}

TEST(Safety, NeverStepsByMoreThanTheSlewLimit)
{
  const double maxStep = SafetyLimits{}.maxSlew * tick_s;
  const double offStep = SafetyLimits{}.maxForce / SafetyLimits{}.offTime * tick_s;
  Safety safety(SafetyLimits{}, tick_s);
  Eigen::Vector3d before_D = Eigen::Vector3d::Zero();
  for (int i = 0; i < 5000; ++i) {
    // a force that changes sign, a hand that releases, becomes stale, jumps and faults
    const double sign = (i / 7) % 2 == 0 ? 1.0 : -1.0;
    HandCondition hand = holding();
    hand.isHeld = i % 1100 < 1050;
    hand.isStale = i % 1300 > 1270;
    hand.hasFault = i % 1700 > 1690;
    hand.hasJumped = i % 900 == 899;
    hand.moved_D = Eigen::Vector3d(1e-5 * sign, 0.0, 2e-5);
    std::uint32_t status = allWell;
    const Eigen::Vector3d now_D = safety.show({sign * 10.0, 3.0, -sign}, hand, status);
    const bool isOff = !hand.isHeld || hand.isStale || hand.hasFault;
    ASSERT_LE((now_D - before_D).norm(), (isOff ? offStep : maxStep) * (1.0 + tolerance)) << i;
    ASSERT_LE(now_D.norm(), 3.3 * (1.0 + tolerance)) << i;
    before_D = now_D;
  }
}

TEST(Safety, FadesInLinearlyOverTheRampTime)
{
  Safety safety(SafetyLimits{}, tick_s);
  const Eigen::Vector3d wanted_D(0.1, 0.0, 0.0);
  for (int tick = 1; tick <= 500; ++tick) {
    std::uint32_t status = allWell;
    const Eigen::Vector3d shown_D = safety.show(wanted_D, holding(), status);
    ASSERT_NEAR(shown_D.x(), 0.1 * tick * tick_s / 0.5, 1e-9) << tick;
    if (tick < 499) {
      ASSERT_NE(status & rampingIn, 0u) << tick;
    }
  }
}

/// Reasons for no force.
class SafetyOff : public testing::TestWithParam<HandCondition> {};

TEST_P(SafetyOff, ShowsNoForceAndFadesInAfterwards)
{
  const Eigen::Vector3d wanted_D(0.0, 0.0, 0.3);
  Safety safety = shownFor(wanted_D);
  std::uint32_t status = allWell;
  // 0.3 N at 100 N/s: three ticks
  for (int i = 0; i < 3; ++i) safety.show(wanted_D, GetParam(), status);
  EXPECT_NEAR(safety.show(wanted_D, GetParam(), status).norm(), 0.0, tolerance);

  status = allWell;
  const Eigen::Vector3d first_D = safety.show(wanted_D, holding(), status);
  EXPECT_LE(first_D.norm(), 0.3 * tick_s / 0.5 * (1.0 + tolerance));
  EXPECT_NE(status & rampingIn, 0u);
}

HandCondition released() { return {}; }
HandCondition stale()
{
  HandCondition hand = holding();
  hand.isStale = true;
  return hand;
}
HandCondition faulty()
{
  HandCondition hand = holding();
  hand.hasFault = true;
  return hand;
}
INSTANTIATE_TEST_SUITE_P(Reasons, SafetyOff, testing::Values(released(), stale(), faulty()));

TEST_P(SafetyOff, IsGoneAsSoonAsTheDevicesOwnGuardWouldAct)
{
  // The device's guard waits three periods, and at least 3 ms (HidDevice.h): at 1 kHz and 10 kHz.
  for (const double step : {1e-3, 1e-4}) {
    Safety safety({}, step);
    const Eigen::Vector3d wanted_D(0.0, 0.0, 10.0);
    std::uint32_t status = allWell;
    for (int i = 0; i < 20000; ++i) safety.show(wanted_D, holding(), status);
    const int ticks = static_cast<int>(std::lround(3e-3 / step));
    for (int i = 0; i + 1 < ticks; ++i) safety.show(wanted_D, GetParam(), status);
    EXPECT_NEAR(safety.show(wanted_D, GetParam(), status).norm(), 0.0, tolerance) << step << " s";
  }
}

TEST_P(SafetyOff, StillGivesNoStep)
{
  Safety safety = shownFor({0.0, 0.0, 3.3});
  std::uint32_t status = allWell;
  EXPECT_NEAR(safety.show(Eigen::Vector3d::Zero(), GetParam(), status).norm(), 2.2, tolerance);
}

TEST(Safety, TakesItsTimeToSwitchOffWhereItIsToldNone)
{
  SafetyLimits limits;
  limits.offTime = 0.0;
  Safety safety = shownFor({0.0, 0.0, 3.3}, limits);
  std::uint32_t status = allWell;
  EXPECT_NEAR(safety.show(Eigen::Vector3d::Zero(), released(), status).norm(), 3.2,
              tolerance);  // 100 N/s for 1 ms
}

TEST(Safety, SaysThatTheHandIsStale)
{
  Safety safety = shownFor({0.1, 0.0, 0.0});
  std::uint32_t status = allWell;
  safety.show({0.1, 0.0, 0.0}, stale(), status);
  EXPECT_NE(status & staleSample, 0u);
}

TEST(Safety, FadesInAgainAfterAJump)
{
  const Eigen::Vector3d wanted_D(0.0, 0.05, 0.0);
  Safety safety = shownFor(wanted_D);
  HandCondition jumped = holding();
  jumped.hasJumped = true;
  std::uint32_t status = allWell;
  EXPECT_EQ(safety.show(wanted_D, jumped, status), Eigen::Vector3d::Zero());
  EXPECT_LT(safety.show(wanted_D, holding(), status).norm(), 0.001);
}

TEST(Safety, TakesTheLowerOfItsOwnAndTheDevicesGreatestForce)
{
  device::DeviceTraits device;
  device.rendersForce = true;
  device.maxForce = 2.0;
  EXPECT_EQ(limitsFor({}, device).maxForce, 2.0);
  device.maxForce = 12.0;
  EXPECT_EQ(limitsFor({}, device).maxForce, 3.3);
  device.rendersForce = false;
  device.maxForce = 0.0;
  EXPECT_EQ(limitsFor({}, device).maxForce, 3.3);
}

TEST(Safety, KeepsItsOwnLimitsForADeviceWithoutLimits)
{
  device::DeviceTraits device;
  device.rendersForce = true;
  device.maxForce = 0.0;
  device.workspaceRadius = 0.0;
  SafetyLimits own;
  own.reach = 0.2;
  EXPECT_EQ(limitsFor(own, device).maxForce, own.maxForce);
  EXPECT_EQ(limitsFor(own, device).reach, 0.2);
  device.workspaceRadius = 0.08;
  EXPECT_EQ(limitsFor(own, device).reach, 0.08);
}

TEST(Safety, MayBeToldToShowLessButNeverMore)
{
  const Eigen::Vector3d wanted_D(0.0, 5.0, 0.0);
  for (const auto& [told, shown] :
       {std::pair{1.0, 1.0}, {20.0, 3.3}, {0.0, 3.3}, {-1.0, 3.3}, {std::nan(""), 3.3}}) {
    Safety safety({}, tick_s);
    safety.lowerMaxForce(told);
    std::uint32_t status = allWell;
    for (int i = 0; i < 1000; ++i) safety.show(wanted_D, holding(), status);
    EXPECT_NEAR(safety.show(wanted_D, holding(), status).y(), shown, tolerance) << told;
  }
}

TEST(Safety, RefusesLimitsThatLimitNothing)
{
  for (const double bad : {0.0, -1.0, std::nan(""), std::numeric_limits<double>::infinity()}) {
    EXPECT_THROW(Safety({bad, 100.0, 0.5}, tick_s), std::invalid_argument) << bad;
    EXPECT_THROW(Safety({3.3, bad, 0.5}, tick_s), std::invalid_argument) << bad;
    EXPECT_THROW(Safety({3.3, 100.0, bad}, tick_s), std::invalid_argument) << bad;
  }
}

TEST(Safety, FadesOutOverTheLastTenthOfTheReach)
{
  SafetyLimits limits;
  limits.reach = 0.1;
  const Eigen::Vector3d force_D(0.2, 0.0, 0.0);
  const std::pair<double, double> fractions[] = {
      {0.0, 1.0}, {0.09, 1.0}, {0.095, 0.5}, {0.1, 0.0}, {0.2, 0.0}};
  for (const auto& [distance, fraction] : fractions) {
    Safety safety = shownFor(force_D, limits);
    HandCondition hand = holding();
    hand.distance = distance;
    std::uint32_t status = allWell;
    for (int i = 0; i < 10; ++i) safety.show(force_D, hand, status);
    EXPECT_NEAR(safety.show(force_D, hand, status).x(), fraction * 0.2, 1e-9) << distance;
    EXPECT_EQ((status & nearWorkspaceEnd) != 0, fraction < 1.0) << distance;
  }
}

TEST(Safety, HasNoWorkspaceLimitWhereTheReachIsUnknown)
{
  Safety safety = shownFor({0.2, 0.0, 0.0});
  HandCondition hand = holding();
  hand.distance = 5.0;
  std::uint32_t status = allWell;
  EXPECT_EQ(safety.show({0.2, 0.0, 0.0}, hand, status).x(), 0.2);
}

}  // namespace
}  // namespace perilymph::haptics
