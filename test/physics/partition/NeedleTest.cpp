// SPDX-License-Identifier: BSD-3-Clause

// A stiff needle pushed up through the cochlear partition: strength, energy, sides.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "../mechanics/TestRod.h"
#include "contact/Contact.h"
#include "perilymph/anatomy/MeanScala.h"
#include "perilymph/anatomy/ScalaVestibuli.h"
#include "perilymph/test/AllocationGuard.h"
#include "perilymph/test/Tolerance.h"

namespace perilymph {
namespace {

using test::RodSpec;
using test::TestRod;

std::shared_ptr<const anatomy::ScalaTympani> meanScala()
{
  static const auto scala = *anatomy::buildMean(millimeters(1));
  return scala;
}

/// A needle tilted upward, its tip free below the partition, without friction.
struct Needle {
  explicit Needle(double strength, double timeStep = 1e-3, double tilt = 0.15)
      : rod(meanScala(), spec(strength, timeStep, tilt))
  {
    up_W = rod.model().entry.vertical_W;
    enter();
  }

  /// Moves the tip below the partition at 31 degrees.
  void enter()
  {
    rod.drive().handPosition_W = rod.model().startBase_W;
    move(-0.3e-3 * up_W);
    move(3.3e-3 * rod.model().startAxis_W - 0.3e-3 * up_W);
    work = maximum = 0.0;
  }

  static RodSpec spec(double strength, double timeStep, double tilt)
  {
    RodSpec spec;
    spec.length = 8e-3;
    spec.radius = 0.1e-3;
    spec.bending = 1e-5;
    spec.startInside = 0.5e-3;
    spec.nodes = 65;
    spec.wallStiffness = 2000.0;
    spec.tilt = tilt;
    spec.timeStep = timeStep;
    spec.partitionStrength = strength;
    return spec;
  }

  /// Moves the hand and adds up its work.
  void move(const Eigen::Vector3d& motion_W, double speed = 1e-3)
  {
    const long steps = std::lround(std::ceil(motion_W.norm() / speed / rod.model().timeStep));
    for (long k = 0; k < steps; ++k) {
      const Eigen::Vector3d before_W = rod.state().base_W;
      const Eigen::Vector3d force_W = rod.readings().handForce_W;
      rod.drive().handPosition_W += motion_W / static_cast<double>(steps);
      rod.tick();
      work -= 0.5 * (force_W + rod.readings().handForce_W).dot(rod.state().base_W - before_W);
      maximum = std::max(maximum, std::fabs(work));
    }
  }

  /// Pushes upward until the partition ruptures. False if it holds for 1.5 mm.
  bool rupture()
  {
    for (int k = 0; k < 1500 && !partition().isRuptured(); ++k) {
      before = rod.readings().handForce_W.z();
      move(0.001e-3 * up_W);
    }
    return partition().isRuptured();
  }

  const mechanics::PartitionState& partition() { return rod.state().partition; }
  bool tipIsAbove() { return partition().isAbove.back() != 0; }
  double tipHeight() { return rod.state().position_W.back().z(); }

  TestRod rod;
  Eigen::Vector3d up_W;
  double work = 0.0;     ///< Work of the hand [J].
  double maximum = 0.0;  ///< Its maximum [J].
  double before = 0.0;   ///< Force on the hand before the rupture [N].
};

TEST(PartitionUnderANeedle, RupturesAtExactlyItsStrength)
{
  for (const double strength : {0.004, 0.01, 0.03}) {
    Needle needle(strength);
    ASSERT_TRUE(needle.rupture()) << strength;
    const mechanics::Rupture& rupture = needle.partition().first;
    // the tip alone touches the partition: the hand carries its force
    EXPECT_EQ(needle.rod.readings().contacts, 1);
    EXPECT_GE(rupture.force, strength);
    EXPECT_NEAR(rupture.force, strength, test::tolerance(0.1e-3, "one step of a micrometer"));
    EXPECT_LT(-needle.before, strength);
    EXPECT_NEAR(-needle.rod.readings().handForce_W.z(), strength,
                test::tolerance(0.01 * strength, "slope of the roof"));
    EXPECT_NEAR(rupture.angle, needle.rod.state().track.back().angle, 1e-9);
    EXPECT_EQ(rupture.tick, needle.rod.state().tick);
  }
}

TEST(PartitionUnderANeedle, ChangesNoBitUntilItRuptures)
{
  Needle strong(2.0), forEver(0.0);
  for (Needle* needle : {&strong, &forEver}) EXPECT_FALSE(needle->rupture());
  EXPECT_EQ(strong.rod.state().fingerprint(), forEver.rod.state().fingerprint());
  EXPECT_TRUE(forEver.partition().isAbove.empty());
  EXPECT_NE(strong.rod.model().fingerprint, forEver.rod.model().fingerprint);
}

TEST(PartitionUnderANeedle, LosesItsEnergyWhenItRuptures)
{
  constexpr double strength = 0.03;
  Needle needle(strength);
  const Eigen::Vector3d start_W = needle.rod.drive().handPosition_W;
  ASSERT_EQ(needle.rod.readings().contacts, 0);
  ASSERT_TRUE(needle.rupture());
  // F = k (p - t / 2) at the tip
  const double k = needle.rod.model().wallStiffness.back();
  const double onset = needle.rod.model().parts.wall.lining.si();
  const double stored = mechanics::energyOf(strength / k + 0.5 * onset, k, onset);
  ASSERT_GT(stored, 0.1e-6);
  needle.move(start_W - needle.rod.drive().handPosition_W);
  ASSERT_EQ(needle.rod.readings().contacts, 0);
  EXPECT_GT(needle.work, stored);
  EXPECT_LT(needle.work, needle.maximum * (1.0 + 1e-9));
}

TEST(PartitionUnderANeedle, LetsTheTipThrough)
{
  Needle needle(0.004);
  ASSERT_TRUE(needle.rupture());
  needle.move(0.5e-3 * needle.up_W);
  EXPECT_TRUE(needle.tipIsAbove());
  EXPECT_GT(needle.tipHeight(),
            meanScala()->section(needle.partition().first.angle).roofHeight + 0.1e-3);
  EXPECT_LT(needle.rod.readings().wallForceMax, 0.004);
}

TEST(PartitionUnderANeedle, LetsTheTipUpToTheRoofOfTheScalaVestibuli)
{
  Needle needle(0.001, 1e-3, 0.5);
  const mechanics::InsertionState& state = needle.rod.state();
  const mechanics::InsertionModel& model = needle.rod.model();
  const auto isAtRoof = [&] {
    return state.normalForce.back() > 2e-3 && state.wallNormal_W.back().z() < -0.8;
  };
  for (int k = 0; k < 2000 && !(needle.tipIsAbove() && isAtRoof()); ++k)
    needle.move(0.001e-3 * needle.up_W);
  ASSERT_TRUE(needle.tipIsAbove());
  ASSERT_TRUE(isAtRoof());
  // F = k (p - t / 2)
  const double penetration =
      state.normalForce.back() / model.wallStiffness.back() + 0.5 * model.parts.wall.lining.si();
  const auto vestibuli = anatomy::vestibuliOf(*meanScala());
  anatomy::LumenTrack track = state.track.back();
  anatomy::WallPoint wall;
  const double reach = 5e-3;
  vestibuli->nearestWall({&state.position_W.back(), 1}, {&reach, 1}, {&track, 1}, {&wall, 1});
  EXPECT_NEAR(wall.distance, model.radius.back() - penetration,
              test::tolerance(0.01e-3, "two tables of distances"));
  const anatomy::Section section = vestibuli->section(track.angle);
  EXPECT_GT(needle.tipHeight(), 0.5 * (section.floorHeight + section.roofHeight));
}

TEST(PartitionUnderANeedle, IsAFloorBeyondTheRupture)
{
  Needle needle(0.004);
  ASSERT_TRUE(needle.rupture());
  needle.move(0.5e-3 * needle.up_W);
  const Eigen::Vector3d inward_W = needle.rod.model().startAxis_W;
  needle.move(0.8e-3 * inward_W);
  const double end = needle.partition().ranges[0].end;
  ASSERT_GT(needle.rod.state().track.back().angle, end);
  needle.move(-0.12e-3 * needle.up_W);
  const double roof = meanScala()->section(needle.rod.state().track.back().angle).roofHeight;
  EXPECT_TRUE(needle.tipIsAbove());
  EXPECT_GT(needle.tipHeight(), roof - 0.05e-3);
}

TEST(PartitionUnderANeedle, GivesAHandNothingInLoopsThroughTheRupture)
{
  for (const double timeStep : {0.5e-3, 2e-3}) {
    Needle needle(0.004, timeStep);
    ASSERT_TRUE(needle.rupture());
    const Eigen::Vector3d in_W = needle.rod.model().startAxis_W;
    const Eigen::Vector3d& up_W = needle.up_W;
    for (int loop = 0; loop < 3; ++loop) {
      needle.work = needle.maximum = 0.0;
      needle.move(0.5e-3 * up_W);
      needle.move(0.8e-3 * in_W);
      needle.move(-0.15e-3 * up_W);
      needle.move(0.15e-3 * up_W);
      needle.move(-0.8e-3 * in_W);
      needle.move(-0.5e-3 * up_W);
      EXPECT_GT(needle.maximum, 0.3e-6);  // the loop loads the partition
      EXPECT_GT(needle.work, -test::tolerance(0.02, "trapezoids") * needle.maximum) << loop;
      // once the edges hold, nothing but damping is lost
      if (loop > 0) {
        EXPECT_LT(needle.work, 0.1 * needle.maximum) << loop;
      }
    }
  }
}

TEST(PartitionUnderANeedle, RepeatsItselfAfterAResetAndAllocatesNothing)
{
  Needle needle(0.004);
  const auto run = [&] {
    needle.enter();
    EXPECT_TRUE(needle.rupture());
    needle.move(0.6e-3 * needle.up_W);
    return needle.rod.state().fingerprint();
  };
  needle.rod.state().reset(needle.rod.model());
  EXPECT_FALSE(needle.partition().isRuptured());
  const std::uint64_t first = run();
  needle.rod.state().reset(needle.rod.model());
  EXPECT_EQ(run(), first);
  const mechanics::InsertionState copy = needle.rod.state();
  EXPECT_EQ(copy.fingerprint(), first);
  if (!test::AllocationGuard::isAvailable()) return;
  const test::AllocationGuard guard;
  needle.move(-0.3e-3 * needle.up_W);
  EXPECT_EQ(guard.allocations(), 0u);
}

}  // namespace
}  // namespace perilymph
