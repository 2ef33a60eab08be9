// SPDX-License-Identifier: BSD-3-Clause

// The ducts above the partition: the scala vestibuli, and both scalae without a partition.

#include <gtest/gtest.h>

#include <cmath>

#include "perilymph/anatomy/MeanScala.h"
#include "perilymph/anatomy/ScalaVestibuli.h"

namespace perilymph::anatomy {
namespace {

/// Both ducts of the mean anatomy.
struct Ducts {
  std::shared_ptr<const ScalaTympani> tympani = *buildMean(millimeters(1));
  std::shared_ptr<const ScalaTympani> vestibuli = vestibuliOf(*tympani);
  std::shared_ptr<const ScalaTympani> both = bothScalaeOf(*tympani);
};

const Ducts& ducts()
{
  static const Ducts mean;
  return mean;
}

/// Signed distance to the wall from above the center of the scala tympani, at this fraction of the
/// way to the center of the scala vestibuli.
WallPoint wallAt(const ScalaTympani& duct, double angle, double fraction)
{
  const Eigen::Vector3d point = (1.0 - fraction) * ducts().tympani->center_W(angle) +
                                fraction * ducts().vestibuli->center_W(angle);
  LumenTrack track{false, angle, {std::cos(angle), std::sin(angle)}};
  WallPoint wall;
  const double reach = 5e-3;
  duct.nearestWall({&point, 1}, {&reach, 1}, {&track, 1}, {&wall, 1});
  return wall;
}

TEST(ScalaVestibuli, IsBuiltOnceForAllArraysInAScala)
{
  EXPECT_EQ(vestibuliOf(*ducts().tympani), ducts().vestibuli);
  EXPECT_EQ(bothScalaeOf(*ducts().tympani), ducts().both);
}

TEST(BothScalae, MeetAtThePartition)
{
  for (const double angle_deg : {60.0, 180.0, 360.0, 540.0}) {
    const double angle = degrees(angle_deg).si();
    const Section below = ducts().tympani->section(angle);
    const Section above = ducts().vestibuli->section(angle);
    EXPECT_NEAR(above.floorHeight, below.roofHeight, 5e-6) << angle_deg;
    EXPECT_NEAR(above.roofHeight - above.floorHeight, below.roofHeight - below.floorHeight, 5e-6);
    EXPECT_NEAR(above.area, below.area, 1e-3 * below.area);
  }
}

TEST(BothScalae, HaveNoWallInTheirMiddle)
{
  for (const double angle_deg : {60.0, 180.0, 360.0, 540.0}) {
    const double angle = degrees(angle_deg).si();
    EXPECT_LT(wallAt(*ducts().tympani, angle, 0.5).distance, 0.02e-3);
    EXPECT_LT(wallAt(*ducts().vestibuli, angle, 0.5).distance, 0.02e-3);
    EXPECT_GT(wallAt(*ducts().both, angle, 0.5).distance, 0.3e-3) << angle_deg;
  }
}

TEST(BothScalae, KeepFloorRoofAndWidth)
{
  for (const double angle_deg : {60.0, 180.0, 360.0, 540.0}) {
    const double angle = degrees(angle_deg).si();
    const Section below = ducts().tympani->section(angle);
    const Section above = ducts().vestibuli->section(angle);
    const Section both = ducts().both->section(angle);
    EXPECT_NEAR(both.floorHeight, below.floorHeight, 0.01e-3) << angle_deg;
    EXPECT_NEAR(both.roofHeight, above.roofHeight, 0.01e-3);
    EXPECT_NEAR(both.innerRadius, below.innerRadius, 0.01e-3);
    EXPECT_NEAR(both.outerRadius, below.outerRadius, 0.01e-3);
    EXPECT_GT(both.area, below.area + above.area);
  }
}

TEST(BothScalae, LeaveAsMuchRoomAsTheScalaTympaniBelowTheMiddle)
{
  for (double angle_deg = 20.0; angle_deg < 600.0; angle_deg += 3.0)
    for (const double fraction : {-0.6, -0.3, 0.0, 0.2, 0.35}) {
      const double angle = degrees(angle_deg).si();
      const WallPoint own = wallAt(*ducts().tympani, angle, fraction);
      const WallPoint both = wallAt(*ducts().both, angle, fraction);
      ASSERT_GT(both.distance, own.distance - 0.02e-3) << angle_deg << " deg, " << fraction;
    }
}

}  // namespace
}  // namespace perilymph::anatomy
