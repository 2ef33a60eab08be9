// SPDX-License-Identifier: BSD-3-Clause

// The bone of volumes whose bone is known in closed form.

#include "perilymph/imaging/BoneSurface.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include "perilymph/test/CtPhantom.h"

namespace perilymph::test {
namespace {

using Eigen::Vector3d;

constexpr double boneHu = 1800.0, airHu = -200.0, level = 0.5 * (boneHu + airHu);
constexpr double voxel_mm = 0.4;
constexpr int edge = 60;

/// A volume, oblique in P, whose bone begins where a signed distance [mm] is positive; blurred
/// linearly over a millimeter, so that the half of both intensities lies on the surface.
ct::CtVolume volumeOf(const std::function<double(const Vector3d& point_P)>& inside_mm)
{
  Eigen::Matrix4d lps = Eigen::Matrix4d::Identity();
  lps.topLeftCorner<3, 3>() =
      voxel_mm * Eigen::AngleAxisd(0.4, Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  lps.topRightCorner<3, 1>() = Vector3d(20, -35, 40);
  std::vector<std::int16_t> voxels;
  for (int k = 0; k < edge; ++k)
    for (int j = 0; j < edge; ++j)
      for (int i = 0; i < edge; ++i) {
        const Vector3d point = (lps * Eigen::Vector4d(i, j, k, 1)).head<3>();
        const double bone = std::clamp(0.5 + inside_mm(point), 0.0, 1.0);
        voxels.push_back(static_cast<std::int16_t>(std::lround(airHu + bone * (boneHu - airHu))));
      }
  return *ct::CtVolume::make({edge, edge, edge}, lps, std::move(voxels));
}

Vector3d centerOf(const ct::CtVolume& volume) { return volume.center_P(); }

Vector3d millimetersOf(const std::array<double, 3>& point)
{
  return 1e3 * Vector3d(point[0], point[1], point[2]);
}

imaging::BoneRequest around(const Vector3d& center_P, double radius_mm, double step_mm)
{
  return {center_P, radius_mm, level, boneHu - airHu, step_mm, {}};
}

/// A cavity of 4 mm in bone.
double cavity(const Vector3d& point_P, const Vector3d& center_P)
{
  return (point_P - center_P).norm() - 4.0;
}

TEST(BoneSurface, LiesOnTheWallOfACavity)
{
  const Vector3d center =
      centerOf(volumeOf([](const Vector3d&) { return 0.0; })) + Vector3d(0.3, -0.2, 0.1);
  const ct::CtVolume volume =
      volumeOf([&center](const Vector3d& point) { return cavity(point, center); });
  // the mean of eight values within a step moves a wall of radius r by less than step^2 / 8 r; the
  // interpolation of a curved wall between voxels by as much
  for (const double step : {0.28, 0.56}) {
    const anatomy::Surface surface = imaging::boneSurface(volume, around(center, 7.0, step));
    ASSERT_GT(surface.triangles.size(), 500U);
    double worst = 0.0;
    std::size_t onCavity = 0, onBall = 0;
    for (const auto& point : surface.points) {
      const double distance = (millimetersOf(point) - center).norm();
      if (distance < 5.5) {
        ++onCavity;
        worst = std::max(worst, std::fabs(distance - 4.0));
      } else {
        ++onBall;  // where the request cuts the bone off
        EXPECT_NEAR(distance, 7.0, 0.5 * step);
      }
    }
    EXPECT_GT(onCavity, 100U);
    EXPECT_GT(onBall, 100U);
    EXPECT_LT(worst, 0.05) << "step " << step;
  }
}

TEST(BoneSurface, IsFlatWhereTheBoneIs)
{
  const Vector3d normal = Vector3d(1, -2, 0.5).normalized();
  const Vector3d center = centerOf(volumeOf([](const Vector3d&) { return 0.0; }));
  const ct::CtVolume volume =
      volumeOf([&](const Vector3d& point) { return normal.dot(center - point) + 0.7; });
  const anatomy::Surface surface = imaging::boneSurface(volume, around(center, 6.0, 0.3));
  std::size_t onPlane = 0;
  for (const auto& point : surface.points) {
    const Vector3d at = millimetersOf(point) - center;
    if (at.norm() > 5.5) continue;
    ++onPlane;
    EXPECT_NEAR(normal.dot(at), 0.7, 0.01);  // linear in space: exact but for the voxels' integers
  }
  EXPECT_GT(onPlane, 300U);
}

TEST(BoneSurface, IsClosedAndItsNormalsPointOutOfTheBone)
{
  const Vector3d center = centerOf(volumeOf([](const Vector3d&) { return 0.0; }));
  const ct::CtVolume volume =
      volumeOf([&center](const Vector3d& point) { return cavity(point, center); });
  const anatomy::Surface surface = imaging::boneSurface(volume, around(center, 7.0, 0.3));
  // by the divergence theorem, whatever its place
  double sixfold = 0.0;
  for (const auto& [a, b, c] : surface.triangles) {
    Eigen::Matrix3d corners;
    corners << millimetersOf(surface.points[static_cast<std::size_t>(a)]) - center,
        millimetersOf(surface.points[static_cast<std::size_t>(b)]) - center,
        millimetersOf(surface.points[static_cast<std::size_t>(c)]) - center;
    sixfold += corners.determinant();
  }
  const double ball = 4.0 / 3.0 * M_PI * (7.0 * 7.0 * 7.0 - 4.0 * 4.0 * 4.0);
  EXPECT_NEAR(sixfold / 6.0, ball, 0.02 * ball);  // positive: outward
}

TEST(BoneSurface, IsEmptyWithoutBoneAndClosedAtTheVolume)
{
  const ct::CtVolume air = volumeOf([](const Vector3d&) { return -5.0; });
  EXPECT_TRUE(imaging::boneSurface(air, around(air.center_P(), 7.0, 0.4)).triangles.empty());
  const ct::CtVolume bone = volumeOf([](const Vector3d&) { return 5.0; });
  EXPECT_TRUE(
      imaging::boneSurface(bone, imaging::wholeBone(bone)).triangles.empty());  // no contrast
  const anatomy::Surface block =
      imaging::boneSurface(bone, around(bone.center_P(), 30.0, voxel_mm));
  ASSERT_FALSE(block.triangles.empty());
  const double half = 0.5 * voxel_mm * (edge - 1);
  double worst = 0.0;
  for (const auto& point : block.points) {
    const Vector3d index = bone.toIndex(millimetersOf(point));
    const Vector3d fromCenter =
        voxel_mm * (index - Vector3d::Constant(0.5 * (edge - 1))).cwiseAbs();
    worst = std::max(worst, std::fabs(fromCenter.maxCoeff() - half));
  }
  // a sample at the border is a mean with what lies outside, and the grid is oblique to it
  EXPECT_LT(worst, 1.25 * voxel_mm);
}

TEST(BoneSurface, OfAPhantomSeparatesItsBoneFromItsLumen)
{
  const CtPhantom phantom = makeCtPhantom(203, highResolutionScan());
  const double found = imaging::boneLevelOf(phantom.volume);
  const auto lumen = phantom.volume.sample(phantom.inside_P);
  ASSERT_TRUE(lumen);
  EXPECT_GT(found, *lumen);
  // the capsule, 1.5 mm outside of the basal turn's wall
  const Vector3d outward =
      (*phantom.marks[ct::Mark::farWall] - *phantom.marks[ct::Mark::modiolus]).normalized();
  const auto capsule = phantom.volume.sample(*phantom.marks[ct::Mark::farWall] + 1.2 * outward);
  ASSERT_TRUE(capsule);
  EXPECT_LT(found, *capsule);
  const anatomy::Surface surface =
      imaging::boneSurface(phantom.volume, imaging::wholeBone(phantom.volume));
  // the lateral wall is a part of it
  double nearest = 1e9;
  for (const auto& point : surface.points)
    nearest = std::min(nearest, (millimetersOf(point) - *phantom.marks[ct::Mark::farWall]).norm());
  EXPECT_LT(nearest, 0.45);  // a sample and a half
}

}  // namespace
}  // namespace perilymph::test
