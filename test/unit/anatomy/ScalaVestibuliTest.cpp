// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/anatomy/ScalaVestibuli.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <map>

#include "perilymph/anatomy/Patient.h"

namespace perilymph::anatomy {
namespace {

Eigen::Vector3d point(const Surface& surface, int index)
{
  const auto& p = surface.points[static_cast<std::size_t>(index)];
  return {p[0], p[1], p[2]};
}

/// Volume enclosed by the surface when its rim is closed by a fan around `rimCenter` [m^3].
double volume(const Surface& surface, const Eigen::Vector3d& rimCenter)
{
  double sum = 0.0;
  for (const auto& t : surface.triangles)
    sum += (point(surface, t[0]) - rimCenter)
               .dot((point(surface, t[1]) - rimCenter).cross(point(surface, t[2]) - rimCenter)) /
           6.0;
  return sum;
}

TEST(ScalaVestibuli, HoldsAsMuchAsTheScalaItMirrors)
{
  const auto scala = buildPublished({}, millimeters(0));
  const Surface below = wallSurface(*scala, 8000);
  const Surface above = vestibuliSurface(*scala, 8000);
  const Eigen::Vector3d start = scala->center_W(0.0);
  const Eigen::Vector3d mirrored(start.x(), start.y(),
                                 2.0 * scala->section(0.0).roofHeight - start.z());
  const double expected = volume(below, start);
  ASSERT_GT(expected, 0.0);
  // Mirroring a section keeps its area and so, by Pappus, the volume. Positive: faces outward.
  EXPECT_NEAR(volume(above, mirrored), expected, 0.01 * expected);
}

TEST(ScalaVestibuli, LiesAboveTheMembraneAllTheWay)
{
  const auto scala = buildPublished({}, millimeters(1));
  const int around = 36;  // corners of a ring of 8000 triangles
  const Surface above = vestibuliSurface(*scala, 8000);
  const int rings = static_cast<int>(above.points.size()) / around;
  for (int i = 0; i < rings; ++i) {
    const double angle = scala->lastAngle().si() * i / (rings - 1);
    const double membrane = scala->membrane_W(angle, 0.5).z();
    for (int k = 0; k < around; ++k)
      ASSERT_GE(point(above, i * around + k).z(), membrane - 1e-9) << "ring " << i;
  }
}

TEST(ScalaVestibuli, IsOpenTowardTheVestibuleAlone)
{
  const Surface surface = vestibuliSurface(*buildPublished({}, millimeters(1)), 5000);
  std::map<std::pair<int, int>, int> edges;
  for (const auto& t : surface.triangles)
    for (std::size_t k = 0; k < 3; ++k) edges[{t[k], t[(k + 1) % 3]}]++;
  for (const auto& [edge, count] : edges) {
    ASSERT_EQ(count, 1);
    if (edges.find({edge.second, edge.first}) != edges.end()) continue;
    // the rim lies in the half-plane of the round window, y = 0
    EXPECT_NEAR(point(surface, edge.first).y(), 0.0, 1e-12);
  }
}

}  // namespace
}  // namespace perilymph::anatomy
