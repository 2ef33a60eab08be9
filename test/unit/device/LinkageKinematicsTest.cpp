// SPDX-License-Identifier: BSD-3-Clause
#include "codec/LinkageKinematics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace perilymph::device {
namespace {

using Vector = std::array<double, 3>;

Linkage arm()
{
  Linkage linkage;
  linkage.height = 0.08;
  linkage.lengthB = 0.205;
  linkage.lengthC = 0.245;
  linkage.countsPerTurn = {2000, 2000, 2000};
  linkage.bodyTurnsPerTurn = {1.0 / 16, -1.0 / 12, 1.0 / 12};
  linkage.torqueConstant = {0.0259, 0.0259, 0.0259};
  linkage.maxCurrent = 2.0;
  return linkage;
}

double length(const Vector& v) { return std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]); }

double power(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

TEST(Linkage, StretchedOutReachesTheSumOfItsLinks)
{
  const double quarter = std::numbers::pi / 2;
  const Vector handle_B = handlePosition_B(arm(), {0, quarter, quarter});
  EXPECT_NEAR(handle_B[0], 0.45, 1e-15);
  EXPECT_NEAR(handle_B[1], 0.0, 1e-15);
  EXPECT_NEAR(handle_B[2], 0.08, 1e-15);
}

TEST(Linkage, HangsItsSecondLinkBelowTheElbowAtRest)
{
  // b = 0: the first link upright; c = 0: the second hangs down.
  const Vector handle_B = handlePosition_B(arm(), {0.7, 0, 0});
  EXPECT_NEAR(handle_B[2], 0.08 + 0.205 - 0.245, 1e-15);
  EXPECT_NEAR(length({handle_B[0], handle_B[1], 0}), 0.0, 1e-15);
}

TEST(Linkage, TurnsItsBodyByTheGearOfCapstanAndBody)
{
  // 16 turns of a 10 mm capstan turn a 160 mm body once.
  const Vector angles = bodyAngles(arm(), {16 * 2000, 12 * 2000, 0});
  EXPECT_NEAR(angles[0], 2 * std::numbers::pi, 1e-12);
  EXPECT_NEAR(angles[1], -2 * std::numbers::pi, 1e-12);
  EXPECT_EQ(angles[2], 0.0);
}

TEST(Linkage, DoesTheWorkOfTheForceAtTheHandle)
{
  // Principle of virtual work; the motion of the handle by central differences.
  const Linkage linkage = arm();
  const double step = 1e-6;
  for (const Vector& angles :
       {Vector{0.1, 1.2, 0.9}, Vector{-0.8, 0.4, 2.0}, Vector{2.5, -0.3, 1.0}})
    for (const Vector& force_B :
         {Vector{1, 0, 0}, Vector{0, 1, 0}, Vector{0, 0, 1}, Vector{2, -3, 1}}) {
      const Vector torques = bodyTorques(linkage, angles, force_B);
      for (std::size_t i = 0; i < 3; ++i) {
        Vector before = angles;
        Vector after = angles;
        before[i] -= step;
        after[i] += step;
        const Vector from = handlePosition_B(linkage, before);
        const Vector to = handlePosition_B(linkage, after);
        const Vector motion{(to[0] - from[0]) / (2 * step), (to[1] - from[1]) / (2 * step),
                            (to[2] - from[2]) / (2 * step)};
        EXPECT_NEAR(torques[i], power(motion, force_B), 1e-8);
      }
    }
}

TEST(LinkageStretchedOut, CannotPushAlongItselfButStaysFinite)
{
  const double quarter = std::numbers::pi / 2;
  const Vector torques = bodyTorques(arm(), {0, quarter, quarter}, {5, 0, 0});
  for (const double torque : torques) EXPECT_NEAR(torque, 0.0, 1e-15);
}

TEST(LinkageOverItsAxis, CannotPushAround)
{
  const Vector torques = bodyTorques(arm(), {0, 0, 0}, {0, 5, 0});
  for (const double torque : torques) EXPECT_NEAR(torque, 0.0, 1e-15);
}

TEST(MotorCurrents, AreTorqueOverGearAndTorqueConstant)
{
  const Vector currents = motorCurrents(arm(), {0.16, 0.12, 0.0});
  EXPECT_NEAR(currents[0], 0.01 / 0.0259, 1e-12);
  EXPECT_NEAR(currents[1], -0.01 / 0.0259, 1e-12);
}

TEST(MotorCurrents, KeepTheDirectionOfTheForceWhenTheyAreTooMuch)
{
  const Vector wanted{4.0, 1.0, -2.0};
  const Linkage linkage = arm();
  const Vector currents = motorCurrents(linkage, wanted);
  double maximum = 0.0;
  for (const double current : currents) maximum = std::max(maximum, std::fabs(current));
  EXPECT_NEAR(maximum, linkage.maxCurrent, 1e-12);
  // converted back to torques: parallel to the requested ones
  for (std::size_t i = 1; i < 3; ++i) {
    const double first = currents[0] * linkage.torqueConstant[0] / linkage.bodyTurnsPerTurn[0];
    const double other = currents[i] * linkage.torqueConstant[i] / linkage.bodyTurnsPerTurn[i];
    EXPECT_NEAR(other / first, wanted[i] / wanted[0], 1e-12);
  }
}

TEST(MotorCurrents, AreZeroForTorquesThatAreNoNumbers)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(motorCurrents(arm(), {nan, 1, 1}), Vector{});
  EXPECT_EQ(motorCurrents(arm(), {0, std::numeric_limits<double>::infinity(), 1}), Vector{});
}

}  // namespace
}  // namespace perilymph::device
