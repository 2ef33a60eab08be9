#include "perilymph/anatomy/HapticSurface.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
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
  const Entry entry = scala->entry();
  double nearest = 1.0, high = -1.0;
  for (const auto& p : hapticSurface(*scala).points) {
    const Eigen::Vector3d place(p[0], p[1], p[2]);
    const double inside = (entry.origin_W - place).dot(entry.out_W);
    EXPECT_GT(inside, -1e-9);
    nearest = std::min(nearest, inside);
    high = std::max(high, p[2]);
  }
  EXPECT_NEAR(nearest, 0.0, 1e-9);
  // it ends with the section at 720 degrees
  EXPECT_NEAR(high, scala->section(degrees(720).si()).roofHeight, 0.03e-3);
}

TEST(CoarseWall, StaysNearTheVisualOne)
{
  // a tenth of the thinnest tip of an array on average is 50 micrometers: coarser would be felt
  for (const char* name : {"published", "mean"}) {
    const auto scala = scalaOf(name);
    const SurfaceDeviation off = deviation(wallSurfaceBefore(*scala, visualTriangles, degrees(720)),
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
  for (const auto& t : surface.triangles) {
    const Eigen::Vector3d middle = (at(t[0]) + at(t[1]) + at(t[2])) / 3.0;
    const Eigen::Vector3d normal = (at(t[1]) - at(t[0])).cross(at(t[2]) - at(t[0]));
    // the nearest center of a section is on the other side of the triangle
    Eigen::Vector3d center = scala->entry().origin_W;
    for (double angle_deg = -1; angle_deg < 725; angle_deg += 3) {
      const Eigen::Vector3d next = scala->center_W(degrees(angle_deg).si());
      if ((next - middle).norm() < (center - middle).norm()) center = next;
    }
    EXPECT_GT(normal.dot(middle - center), 0.0);
  }
}

}  // namespace
}  // namespace perilymph::anatomy
