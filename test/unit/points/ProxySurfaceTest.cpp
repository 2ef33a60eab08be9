// SPDX-License-Identifier: BSD-3-Clause
#include "points/ProxySurface.h"

#include <gmock/gmock.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>

#include "perilymph/anatomy/HapticSurface.h"
#include "perilymph/anatomy/Patient.h"
#include "perilymph/anatomy/SurfaceDistance.h"
#include "points/HalfSpaces.h"

namespace perilymph::mechanics {
namespace {

using anatomy::Surface;
using Eigen::Vector3d;

constexpr double radius = 0.25e-3;
constexpr double half = 2e-3;      // half the side of the box [m]
constexpr double roundOff = 5e-9;  // a few tolerances of the solver [m]

/// A box around the origin whose sides face outward: a proxy stays inside.
Surface box()
{
  Surface surface;
  for (int i = 0; i < 8; ++i)
    surface.points.push_back(
        {(i & 1) != 0 ? half : -half, (i & 2) != 0 ? half : -half, (i & 4) != 0 ? half : -half});
  surface.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                       {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  return surface;
}

/// Distance from a point to the nearest triangle onto which it projects from the inner side; nearer
/// triangles of a neighboring turn show their outer side.
double distanceInFront(const Surface& surface, const Vector3d& place)
{
  const auto at = [&surface](int i) {
    const auto& p = surface.points[static_cast<std::size_t>(i)];
    return Vector3d(p[0], p[1], p[2]);
  };
  double nearest = 1.0;
  for (const auto& t : surface.triangles) {
    const Vector3d a = at(t[0]), b = at(t[1]), c = at(t[2]);
    const Vector3d outward = (b - a).cross(c - a);
    const Vector3d weights = anatomy::barycentricWeights(place, a, b, c);
    if (weights.minCoeff() <= 0.0) continue;
    const double height = -outward.dot(place - a) / outward.norm();
    if (height > 0.0) nearest = std::min(nearest, height);
  }
  return nearest;
}

/// Moves the proxy toward a goal until it rests.
ProxyHold settled(const ProxySurface& surface, Vector3d proxy, const Vector3d& goal)
{
  ProxyHold hold{};
  HalfSpaces allowed;
  for (int i = 0; i < 100; ++i) {
    hold = surface.follow(proxy, goal, radius, allowed);
    proxy = hold.place_W;
  }
  return hold;
}

TEST(ProxyInABox, StandsAtTheAllowedPlaceNearestToItsGoal)
{
  // In a box shrunk by the radius the nearest point has clamped coordinates, at sides, edges and
  // corners.
  const ProxySurface surface(box(), radius);
  std::mt19937 random(1);
  std::uniform_real_distribution<double> place(-2.0 * half, 2.0 * half);
  for (int i = 0; i < 200; ++i) {
    const Vector3d goal(place(random), place(random), place(random));
    Vector3d expected;
    for (int k = 0; k < 3; ++k) expected[k] = std::clamp(goal[k], radius - half, half - radius);
    const ProxyHold hold = settled(surface, {0.1e-3, -0.2e-3, 0.3e-3}, goal);
    EXPECT_LT((hold.place_W - expected).norm(), roundOff) << goal.transpose();
    EXPECT_LT((hold.pressed_W - (expected - goal)).norm(), 2 * roundOff) << goal.transpose();
    EXPECT_EQ(hold.touches, (expected - goal).norm() > 0.0) << goal.transpose();
  }
}

TEST(Proxy, IsNotHeldFromBehind)
{
  const ProxySurface surface(box(), radius);
  const Vector3d goal(1e-3, 0.5e-3, 0.2e-3);
  const ProxyHold hold = settled(surface, {5e-3, 0.5e-3, 0.2e-3}, goal);
  EXPECT_EQ(hold.place_W, goal);
  EXPECT_FALSE(hold.touches);
}

TEST(Proxy, StaysOnItsOwnSideOfAThinWall)
{
  // the walls of two neighboring turns, a tenth of a millimeter apart and back to back
  Surface walls;
  walls.points = {{-9e-3, -9e-3, 0.0},    {9e-3, -9e-3, 0.0},    {0.0, 9e-3, 0.0},
                  {-9e-3, -9e-3, 0.1e-3}, {9e-3, -9e-3, 0.1e-3}, {0.0, 9e-3, 0.1e-3}};
  walls.triangles = {{0, 1, 2}, {3, 5, 4}};  // outward: up for the lower one, down for the upper
  const ProxySurface surface(walls, radius);
  const ProxyHold below = settled(surface, {0.0, 0.0, -1e-3}, {0.3e-3, 0.0, 3e-3});
  EXPECT_NEAR(below.place_W.z(), -radius, roundOff);
  EXPECT_NEAR(below.place_W.x(), 0.3e-3, roundOff);
  const ProxyHold above = settled(surface, {0.0, 0.0, 1e-3}, {0.3e-3, 0.0, -3e-3});
  EXPECT_NEAR(above.place_W.z(), 0.1e-3 + radius, roundOff);
}

TEST(Proxy, KeepsItsRadiusFromThePublishedScalaWhereverItsGoalIs)
{
  // as far as a straight carrier can reach, and well before the turns overlap
  const auto scala = anatomy::buildPublished({}, millimeters(1));
  const Surface triangles = anatomy::hapticSurface(*scala);
  const ProxySurface surface(triangles, radius);
  std::mt19937 random(7);
  std::uniform_real_distribution<double> away(-1.5e-3, 1.5e-3);
  int touching = 0;
  HalfSpaces allowed;
  for (double angle_deg = 30; angle_deg <= 190; angle_deg += 10) {
    const Vector3d center = scala->center_W(degrees(angle_deg).si());
    Vector3d proxy = center;
    for (int i = 0; i < 40; ++i) {
      const ProxyHold hold = surface.follow(
          proxy, center + Vector3d(away(random), away(random), away(random)), radius, allowed);
      proxy = hold.place_W;
      EXPECT_GT(distanceInFront(triangles, proxy), radius - roundOff) << angle_deg;
      if (hold.touches) ++touching;
    }
    // at rest it is on the surface within a micrometer
    const ProxyHold rest = settled(surface, proxy, scala->wall_W(degrees(angle_deg).si(), 1.0));
    EXPECT_TRUE(rest.touches);
    EXPECT_GT(distanceInFront(triangles, rest.place_W), radius - roundOff) << angle_deg;
  }
  EXPECT_GT(touching, 200);
}

TEST(Proxy, PropagatesANonFiniteGoal)
{
  const ProxySurface surface(box(), radius);
  HalfSpaces allowed;
  const ProxyHold hold =
      surface.follow(Vector3d::Zero(), Vector3d::Constant(std::nan("")), radius, allowed);
  EXPECT_FALSE(hold.pressed_W.allFinite());
}

TEST(ProxySurface, RefusesSurfacesThatHoldNothing)
{
  const auto refusal = [](const Surface& surface) {
    try {
      ProxySurface{surface, radius};
      return std::string("accepted");
    } catch (const std::invalid_argument& error) {
      return std::string(error.what());
    }
  };
  EXPECT_THAT(refusal({}), testing::HasSubstr("no triangles"));
  Surface bad = box();
  bad.points[3][1] = std::nan("");
  EXPECT_THAT(refusal(bad), testing::HasSubstr("not a number"));
  Surface inMillimeters = box();
  for (auto& point : inMillimeters.points)
    for (double& value : point) value *= 1e3;
  EXPECT_THAT(refusal(inMillimeters), testing::HasSubstr("mm wide"));
}

}  // namespace
}  // namespace perilymph::mechanics
