// SPDX-License-Identifier: BSD-3-Clause

// The array as a surface: closed, with the volume of the body that it shows.

#include "ArraySurface.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <map>

#include "perilymph/foundation/Units.h"

namespace perilymph::broadcast {
namespace {

constexpr double within = 0.25e-3, across = 0.4e-3;  // half the diameters [m]
// The area of a 16-gon inscribed in a circle, relative to the circle.
const double polygon = 8.0 / pi * std::sin(pi / 8.0);

/// A quarter of a circle around the modiolar axis.
BroadcastFrame quarter(double radius)
{
  BroadcastFrame frame;
  frame.nodes = 200;
  for (std::uint32_t i = 0; i < frame.nodes; ++i) {
    const double angle = 0.5 * pi * i / (frame.nodes - 1);
    frame.node_W[i] = {float(radius * std::cos(angle)), float(radius * std::sin(angle)), 0.0f};
    frame.halfWidth[i] = {float(within), float(across)};
  }
  return frame;
}

Eigen::Vector3d at(const anatomy::Surface& surface, int i)
{
  const auto& place = surface.points[static_cast<std::size_t>(i)];
  return {place[0], place[1], place[2]};
}

/// Positive if the triangles are counterclockwise seen from outside.
double volumeOf(const anatomy::Surface& surface)
{
  double volume = 0.0;
  for (const auto& [a, b, c] : surface.triangles)
    volume += at(surface, a).dot(at(surface, b).cross(at(surface, c))) / 6.0;
  return volume;
}

TEST(ArraySurface, IsClosedAndOriented)
{
  const auto surface = arraySurface(quarter(4e-3));
  std::map<std::pair<int, int>, int> edges;  // directed
  for (const auto& [a, b, c] : surface.triangles)
    for (const auto& edge : {std::pair{a, b}, std::pair{b, c}, std::pair{c, a}}) ++edges[edge];
  for (const auto& [edge, count] : edges) {
    EXPECT_EQ(count, 1);
    EXPECT_EQ(edges.count({edge.second, edge.first}), 1u);
  }
  // a sphere, topologically
  EXPECT_EQ(int(surface.points.size()) - int(edges.size() / 2) + int(surface.triangles.size()), 2);
}

TEST(ArraySurface, HasTheVolumeOfATubeWithARoundTip)
{
  constexpr double radius = 4e-3;
  const double length = 0.5 * pi * radius;
  // Half an ellipsoid at the tip, as long as its half width within the plane of curl.
  const double expected = polygon * pi * within * across * (length - within + 2.0 / 3.0 * within);
  // The six rings of the cap are inscribed in it, too.
  EXPECT_NEAR(volumeOf(arraySurface(quarter(radius))), expected, 0.002 * expected);
}

TEST(ArraySurface, TurnsTheSectionTowardTheModiolarAxis)
{
  constexpr double radius = 4e-3;
  const auto surface = arraySurface(quarter(radius));
  double low = 1.0, high = 0.0, top = 0.0;
  for (const auto& [x, y, z] : surface.points) {
    low = std::min(low, std::hypot(x, y));
    high = std::max(high, std::hypot(x, y));
    top = std::max(top, z);
  }
  EXPECT_NEAR(low, radius - within, 1e-7);
  EXPECT_NEAR(high, radius + within, 1e-7);
  EXPECT_NEAR(top, across, 1e-7);
}

TEST(ArraySurface, EndsAtTheTip)
{
  const auto surface = arraySurface(quarter(4e-3));
  double farthest = 0.0;  // the tip is at y = 4 mm and points against x
  for (const auto& place : surface.points) farthest = std::min(farthest, place[0]);
  EXPECT_NEAR(farthest, 0.0, 1e-7);
}

TEST(ArraySurface, IsEmptyWithoutNodes)
{
  EXPECT_TRUE(arraySurface(BroadcastFrame{}).triangles.empty());
}

}  // namespace
}  // namespace perilymph::broadcast
