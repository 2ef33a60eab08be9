// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/anatomy/HapticSurface.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <memory>

#include "perilymph/anatomy/MeanScala.h"
#include "perilymph/anatomy/Patient.h"
#include "perilymph/anatomy/SurfaceDeviation.h"

namespace perilymph::anatomy {
namespace {

std::shared_ptr<const ScalaTympani> scalaOf(const std::string& name)
{
  return name == "mean" ? *buildMean(millimeters(1)) : buildPublished({}, millimeters(1));
}

TEST(CoarseWall, HasNinetyFivePercentFewerTrianglesThanTheVisualOne)
{
  for (const char* name : {"published", "mean"}) {
    const auto scala = scalaOf(name);
    const auto visual = static_cast<double>(wallSurface(*scala, visualTriangles).triangles.size());
    const auto haptic = static_cast<double>(hapticSurface(*scala).triangles.size());
    EXPECT_LE(haptic, 0.0502 * visual) << name;
    EXPECT_GT(haptic, 0.045 * visual) << name;
  }
}

TEST(CoarseWall, GoesFromTheOpeningToTwoTurnsAndNoFarther)
{
  const auto scala = scalaOf("published");
  // the rim of the opening: the first section, extruded to the start of the lead-in
  int atOpening = 0;
  double high = -1.0;
  for (const auto& p : hapticSurface(*scala).points) {
    for (double direction = 0.0; direction < 6.28; direction += 2.0 * pi / 112)
      if ((Eigen::Vector3d(p[0], p[1], p[2]) - scala->wall_W(-1.0, direction)).norm() < 1e-9)
        ++atOpening;
    high = std::max(high, p[2]);
  }
  EXPECT_GE(atOpening, 8);
  // it ends with the section at 720 degrees
  EXPECT_NEAR(high, scala->section(degrees(720).si()).roofHeight, 0.03e-3);
}

TEST(CoarseWall, StaysNearTheVisualOne)
{
  // on average 50 um, a tenth of the thinnest array tip: a coarser surface could be felt
  for (const char* name : {"published", "mean"}) {
    const auto scala = scalaOf(name);
    const SurfaceDeviation off =
        surfaceDistance(wallSurfaceBefore(*scala, visualTriangles, degrees(720)),
                        hapticSurface(*scala), millimeters(0.05));
    EXPECT_LT(off.mean, millimeters(0.025)) << name;
    EXPECT_LT(off.p95, millimeters(0.065)) << name;
    EXPECT_LT(off.greatest, millimeters(0.17)) << name;
  }
}

TEST(CoarseWall, FacesOutwardEverywhere)
{
  const auto scala = scalaOf("published");
  const Surface surface = hapticSurface(*scala);
  const auto at = [&surface](int i) {
    const auto& p = surface.points[static_cast<std::size_t>(i)];
    return Eigen::Vector3d(p[0], p[1], p[2]);
  };
  // Each edge occurs at most once in each direction: the orientation is consistent.
  std::map<std::pair<int, int>, int> edges;
  int outward = 0, inward = 0;
  for (const auto& t : surface.triangles) {
    for (std::size_t k = 0; k < 3; ++k) EXPECT_EQ(++(edges[{t[k], t[(k + 1) % 3]}]), 1);
    // The outermost wall of the basal turn faces away from the axis.
    const Eigen::Vector3d middle = (at(t[0]) + at(t[1]) + at(t[2])) / 3.0;
    if (std::hypot(middle.x(), middle.y()) < 4.5e-3 || middle.x() < 0.0) continue;
    const Eigen::Vector3d normal = (at(t[1]) - at(t[0])).cross(at(t[2]) - at(t[0]));
    const double along = (normal.x() * middle.x() + normal.y() * middle.y()) /
                         (normal.norm() * std::hypot(middle.x(), middle.y()));
    if (along > 0.7) ++outward;
    if (along < -0.7) ++inward;
  }
  EXPECT_GT(outward, 2 * inward);
}

}  // namespace
}  // namespace perilymph::anatomy
