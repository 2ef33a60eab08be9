// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/anatomy/SurfaceDistance.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "perilymph/anatomy/Patient.h"
#include "perilymph/anatomy/SurfaceDeviation.h"

namespace perilymph::anatomy {
namespace {

/// A cube of side 2 around the origin.
Surface cube(double lift = 0.0)
{
  Surface surface;
  for (int i = 0; i < 8; ++i)
    surface.points.push_back(
        {(i & 1) ? 1.0 : -1.0, (i & 2) ? 1.0 : -1.0, ((i & 4) ? 1.0 : -1.0) + lift});
  surface.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                       {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  return surface;
}

TEST(SurfaceDistance, IsThatOfACubeInClosedForm)
{
  const SurfaceDistance distance(cube());
  std::mt19937 random(7);
  std::uniform_real_distribution<double> places(-3.0, 3.0);
  for (int i = 0; i < 500; ++i) {
    const Eigen::Vector3d p(places(random), places(random), places(random));
    const Eigen::Vector3d out = p.cwiseAbs() - Eigen::Vector3d::Ones();
    const double expected = out.maxCoeff() > 0.0 ? out.cwiseMax(0.0).norm() : -out.maxCoeff();
    const SurfaceFoot foot = distance.nearest(p, 10.0);
    ASSERT_GE(foot.triangle, 0);
    EXPECT_NEAR(foot.distance, expected, 1e-12);
    EXPECT_NEAR((foot.place - p).norm(), expected, 1e-12);
    EXPECT_NEAR(foot.weights.sum(), 1.0, 1e-12);
  }
}

TEST(SurfaceDistance, FindsNothingBeyondItsReach)
{
  const SurfaceDistance distance(cube());
  EXPECT_EQ(distance.nearest({0.0, 0.0, 1.6}, 0.5).triangle, -1);
  EXPECT_GE(distance.nearest({0.0, 0.0, 1.4}, 0.5).triangle, 0);
  EXPECT_EQ(distance.nearest({std::nan(""), 0.0, 0.0}, 0.5).triangle, -1);
  EXPECT_EQ(SurfaceDistance(Surface{}).nearest({0.0, 0.0, 0.0}).triangle, -1);
}

TEST(SurfaceDeviation, IsNothingBetweenASurfaceAndItself)
{
  const SurfaceDeviation same = surfaceDistance(cube(), cube(), meters(0.2));
  EXPECT_NEAR(same.greatest.si(), 0.0, 1e-12);
}

TEST(SurfaceDeviation, TellsALiftedCubeFromItself)
{
  // Floor and roof of a cube lifted by 0.1 are off by 0.1. Of each side only the part that does not
  // overlap, 0.1 of 2, is off, by 0.05 on average. By symmetry both directions agree.
  const SurfaceDeviation lifted = surfaceDistance(cube(0.1), cube(), meters(0.02));
  const double walls = 4.0 * 0.05 * 0.05;
  EXPECT_NEAR(lifted.mean.si(), (2.0 * 0.1 + walls) / 6.0, 0.002);
  EXPECT_NEAR(lifted.p95.si(), 0.1, 1e-9);
  EXPECT_NEAR(lifted.greatest.si(), 0.1, 1e-9);
}

TEST(WallSurfaceBefore, IsTheSameWallWithoutTheApex)
{
  const auto scala = buildPublished({}, millimeters(1));
  const Surface whole = wallSurface(*scala, 4000);
  const Surface part = wallSurfaceBefore(*scala, 4000, degrees(720));
  ASSERT_LT(part.points.size(), whole.points.size());
  for (std::size_t i = 0; i < part.points.size(); ++i) ASSERT_EQ(part.points[i], whole.points[i]);
  for (std::size_t i = 0; i < part.triangles.size(); ++i)
    ASSERT_EQ(part.triangles[i], whole.triangles[i]);
  // Rings are equally spaced along the outer wall: the ratio of its length up to 720 degrees to its
  // whole length.
  double before = 0.0, all = 0.0;
  for (double angle_deg = 1.0; angle_deg < 994.0; angle_deg += 1.0) {
    const double step = (scala->wall_W(degrees(angle_deg).si(), 0.0) -
                         scala->wall_W(degrees(angle_deg - 1.0).si(), 0.0))
                            .norm();
    all += step;
    if (angle_deg <= 720.0) before += step;
  }
  EXPECT_NEAR(
      static_cast<double>(part.triangles.size()) / static_cast<double>(whole.triangles.size()),
      before / all, 0.02);
}

}  // namespace
}  // namespace perilymph::anatomy
