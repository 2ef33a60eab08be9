// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/haptics/Passivity.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "perilymph/haptics/Safety.h"
#include "perilymph/haptics/Snapshot.h"

namespace perilymph::haptics {
namespace {

constexpr double timeStep = 1e-3;
constexpr double handleMass = 0.09;  // of a consumer device [kg]

/// Energy that left a port, as computed by the test.
struct Account {
  double putIn = 0.0;     // net energy from the hand [J]
  double oneTick = 0.0;   // maximum energy of one tick [J]
  double minimum = 0.0;   // minimum of putIn less the energy of one tick [J]
  double maxSpeed = 0.0;  // [m/s]
};

/// A free handle that hits a wall at 0.1 m/s; the wall's force is some ticks late and so throws it
/// back faster than it came.
template <class Show>
Account throwAgainstDelayedWall(double stiffness, std::size_t delay, Show show)
{
  std::array<double, 16> past{};
  Eigen::Vector3d moved_D = Eigen::Vector3d::Zero();
  double place = 1e-3, speed = -0.1, shown = 0.0;
  Account account;
  for (std::size_t tick = 0; tick < 2000; ++tick) {
    past[tick % past.size()] = std::max(0.0, -stiffness * place);
    const double wanted = tick < delay ? 0.0 : past[(tick - delay) % past.size()];
    shown = show(Eigen::Vector3d(0.0, 0.0, wanted), moved_D).z();

    speed += shown / handleMass * timeStep;
    const double step = speed * timeStep;
    place += step;
    moved_D = Eigen::Vector3d(0.0, 0.0, step);
    account.putIn -= shown * step;
    account.oneTick = std::max(account.oneTick, std::abs(shown * step));
    account.minimum = std::min(account.minimum, account.putIn + account.oneTick);
    account.maxSpeed = std::max(account.maxSpeed, std::abs(speed));
  }
  return account;
}

TEST(DelayedWall, GivesMoreEnergyThanItGotWithoutAController)
{
  const Account account = throwAgainstDelayedWall(
      441.0, 3, [](const Eigen::Vector3d& wanted_D, const Eigen::Vector3d&) { return wanted_D; });
  EXPECT_LT(account.minimum, 0.0);
  EXPECT_GT(account.maxSpeed, 0.11);
}

TEST(DelayedWall, ReturnsAtMostTheEnergyOfOneTickUnderTheController)
{
  for (const double stiffness : {100.0, 441.0, 1000.0}) {
    for (const std::size_t delay : {0u, 1u, 3u}) {
      Passivity passivity(timeStep);
      Eigen::Vector3d shown_D = Eigen::Vector3d::Zero();
      const Account account = throwAgainstDelayedWall(
          stiffness, delay, [&](const Eigen::Vector3d& wanted_D, const Eigen::Vector3d& moved_D) {
            passivity.observe(shown_D, moved_D);
            shown_D = passivity.control(wanted_D, moved_D);
            return shown_D;
          });
      EXPECT_EQ(account.minimum, 0.0) << stiffness << " N/m, " << delay << " ticks late";
      EXPECT_LE(account.maxSpeed, 0.105) << stiffness << " N/m, " << delay << " ticks late";
    }
  }
}

TEST(DelayedWall, IsDampedThroughTheWholeSafetyChainAsWell)
{
  Safety safety(SafetyLimits{3.3, 1e3, 1e-3}, timeStep);
  HandCondition hand;
  hand.isHeld = true;
  std::uint32_t status = allWell;
  const Account account = throwAgainstDelayedWall(
      441.0, 3, [&](const Eigen::Vector3d& wanted_D, const Eigen::Vector3d& moved_D) {
        hand.moved_D = moved_D;
        return safety.show(wanted_D, hand, status);
      });
  EXPECT_EQ(account.minimum, 0.0);
  EXPECT_NE(status & passivityActed, 0u);
  // the chain computes the same energy, one motion later
  EXPECT_NEAR(safety.energy(), account.putIn, account.oneTick);
}

TEST(Passivity, LeavesAPassiveSpringAlone)
{
  // A hand that presses a spring slowly gets its energy back and no more.
  Passivity passivity(timeStep);
  Eigen::Vector3d shown_D = Eigen::Vector3d::Zero();
  constexpr double stiffness = 441.0, step = 1e-6;
  for (int i = 1; i <= 1000; ++i) {
    const double place = -step * i;
    const Eigen::Vector3d moved_D(0.0, 0.0, -step);
    passivity.observe(shown_D, moved_D);
    const Eigen::Vector3d wanted_D(0.0, 0.0, -stiffness * place);
    shown_D = passivity.control(wanted_D, moved_D);
    ASSERT_EQ(shown_D, wanted_D) << i;
  }
  // K x^2 / 2 less half a step, because the force lags by a tick
  EXPECT_NEAR(passivity.energy(), 0.5 * stiffness * 1e-6, stiffness * 1e-3 * step);
}

TEST(Passivity, LimitsItsDampingToThatOfAPassiveSampledDamper)
{
  Passivity passivity(timeStep);
  const Eigen::Vector3d moved_D(1e-6, 0.0, 0.0);
  const Eigen::Vector3d shown_D = passivity.control({3.0, 0.0, 0.0}, moved_D);
  const double speed = 1e-6 / timeStep;
  EXPECT_NEAR(3.0 - shown_D.x(), Passivity::maxDamping * speed, 1e-12);
}

}  // namespace
}  // namespace perilymph::haptics
