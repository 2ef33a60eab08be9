// SPDX-License-Identifier: BSD-3-Clause

// The line of approach in the patient: right and left ears in any pose, and its distance from marks
// against closed forms and a fine sampling.

#include "perilymph/ct/ApproachLine.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <random>
#include <vector>

#include "perilymph/anatomy/MeanScala.h"
#include "perilymph/test/Tolerance.h"

namespace perilymph::ct {
namespace {

using Eigen::Vector3d;

double between_deg(const Vector3d& one, const Vector3d& other)
{
  const double a = one.norm(), b = other.norm(), c = (one - other).norm();
  return std::acos(std::clamp((a * a + b * b - c * c) / (2.0 * a * b), -1.0, 1.0)) * 180.0 / pi;
}

/// Measures of a cochlea in a random pose; only the frame of its anatomy is set.
CochleaMeasures inRandomPose(std::mt19937& dice, bool isLeft)
{
  std::normal_distribution<double> normal;
  const Eigen::Quaterniond pose =
      Eigen::Quaterniond(normal(dice), normal(dice), normal(dice), normal(dice)).normalized();
  CochleaMeasures measures;
  measures.anatomyAxes_PW = pose.toRotationMatrix();
  if (isLeft) measures.anatomyAxes_PW.col(1) *= -1.0;
  measures.anatomyOrigin_P = {30.0 * normal(dice), 30.0 * normal(dice), 30.0 * normal(dice)};
  measures.side = isLeft ? anatomy::Side::left : anatomy::Side::right;
  return measures;
}

/// Voxels with these edges along x, y and z.
Eigen::Matrix3d voxels(const Vector3d& edges_mm) { return edges_mm.asDiagonal(); }

TEST(TheLineOfApproach, HasItsAnglesToTheBasalTurnInThePatientToo)
{
  const auto mean = anatomy::buildMean(millimeters(1));
  ASSERT_TRUE(mean) << mean.error().message;
  const anatomy::Entry entry = (*mean)->entry();
  std::mt19937 dice(3);
  std::uniform_real_distribution<double> angle(-30.0, 30.0);
  for (int k = 0; k < 400; ++k) {
    const CochleaMeasures measures = inRandomPose(dice, k % 2 == 1);
    const anatomy::Approach approach{degrees(angle(dice)), degrees(angle(dice))};
    const ApproachLine line = approachLine(measures, entry, approach);
    const anatomy::BasalTurnAngles angles = anatomy::anglesToBasalTurn(approach, entry);

    // the same angles by points in P: of the opening, of the round window's center line, of the axis
    const Vector3d opening = measures.fromAnatomy(entry.origin_W);
    const Vector3d inside = measures.fromAnatomy((*mean)->center_W(0.0));
    const Vector3d base = measures.fromAnatomy({0, 0, 0}),
                   apex = measures.fromAnatomy({0, 0, 4e-3});
    const Vector3d axis = (apex - base).normalized(), tangent = inside - opening;
    const Vector3d into = line.opening_P - line.at(10.0);
    const auto shadow = [&axis](const Vector3d& v) -> Vector3d { return v - v.dot(axis) * axis; };
    EXPECT_LT((line.opening_P - opening).norm(), 1e-9);
    EXPECT_NEAR(std::fabs(inDegrees(angles.inPlane)), between_deg(shadow(into), shadow(tangent)),
                test::tolerance(0.1, "as stated"));
    EXPECT_NEAR(inDegrees(angles.outOfPlane), between_deg(tangent, axis) - between_deg(into, axis),
                test::tolerance(0.1, "as stated"));
    // toward the lateral wall, in either ear: away from the axis
    const Vector3d outward = shadow(inside - base);
    if (std::fabs(inDegrees(angles.inPlane)) > 0.5) {
      const Vector3d aside = shadow(into).normalized() - shadow(tangent).normalized();
      EXPECT_EQ(aside.dot(outward) > 0.0, angles.inPlane.si() > 0.0) << k;
    }
    const anatomy::Approach again = approachAlong(measures, entry, 7.0 * line.outward_P);
    EXPECT_NEAR(inDegrees(again.tilt), inDegrees(approach.tilt), 1e-9);
    EXPECT_NEAR(inDegrees(again.turn), inDegrees(approach.turn), 1e-9);
  }
}

TEST(DistanceToLine, IsTheLegOfARightTriangle)
{
  const ApproachLine line{{10, 0, 0}, {0, 0, 1}};
  const Eigen::Matrix3d volume = voxels({0.2, 0.2, 0.2});
  const std::vector<Vector3d> beside{{13, 4, 12}};  // legs 3 and 4
  const DistanceToLine found = distanceToLine(beside, line, volume);
  EXPECT_NEAR(found.distance_mm, 5.0, 1e-12);
  EXPECT_NEAR(found.outside_mm, 12.0, 1e-12);
  // the line ends at the opening: inside, the distance is to the opening
  const std::vector<Vector3d> inside{{10, 3, -4}};
  EXPECT_NEAR(distanceToLine(inside, line, volume).distance_mm, 5.0, 1e-12);
  EXPECT_NEAR(distanceToLine(inside, line, volume).outside_mm, 0.0, 1e-12);
  // two skew lines at right angles, 2 mm apart, whose points are far from the nearest place
  const std::vector<Vector3d> across{{2, 2, 7}, {40, 2, 7}};
  EXPECT_NEAR(distanceToLine(across, line, volume).distance_mm, 2.0, 1e-12);
  EXPECT_LT((distanceToLine(across, line, volume).mark_P - Vector3d(10, 2, 7)).norm(), 1e-12);
}

TEST(DistanceToLine, IsTheLeastOfAFineSampling)
{
  std::mt19937 dice(11);
  std::uniform_real_distribution<double> place(-15.0, 15.0);
  const Eigen::Matrix3d volume = voxels({0.3, 0.3, 0.6});
  const auto random = [&] { return Vector3d(place(dice), place(dice), place(dice)); };
  for (int k = 0; k < 60; ++k) {
    const ApproachLine line{random(), random().normalized()};
    const std::vector<Vector3d> mark{random(), random(), random()};
    double least = 1e9;
    for (std::size_t part = 0; part + 1 < mark.size(); ++part)
      for (int i = 0; i <= 400; ++i) {
        const Vector3d at = mark[part] + i / 400.0 * (mark[part + 1] - mark[part]);
        for (int j = 0; j <= 600; ++j) least = std::min(least, (at - line.at(0.1 * j)).norm());
      }
    const double found = distanceToLine(mark, line, volume).distance_mm;
    EXPECT_LE(found, least + 1e-9);
    EXPECT_NEAR(found, least, test::tolerance(0.08, "half of a sampling step along the line"));
  }
}

TEST(DistanceToLine, HasTheErrorOfPlacingAndOfTheVoxelAcross)
{
  const ApproachLine line{{0, 0, 0}, {0, 0, 1}};
  const std::vector<Vector3d> along_x{{4, 0, 9}}, along_y{{0, 4, 9}};
  // placing with a standard deviation of 0.3 mm; a uniform place within 1.2 mm has 1.2 / sqrt(12)
  const Eigen::Matrix3d volume = voxels({1.2, 0.0012, 0.6});
  EXPECT_NEAR(distanceToLine(along_x, line, volume).sd_mm, std::hypot(0.3, 0.34641), 1e-4);
  EXPECT_NEAR(distanceToLine(along_y, line, volume).sd_mm, 0.3, 1e-4);
  // along the diagonal of an oblique voxel
  const Eigen::Matrix3d oblique =
      Eigen::AngleAxisd(pi / 4.0, Vector3d::UnitZ()).toRotationMatrix() * volume;
  EXPECT_NEAR(distanceToLine(along_x, line, oblique).sd_mm,
              std::hypot(0.3, 0.34641 * std::sqrt(0.5)), 1e-4);
  // on the line, the voxel's longest edge
  const std::vector<Vector3d> on{{0, 0, 3}};
  EXPECT_NEAR(distanceToLine(on, line, volume).sd_mm, std::hypot(0.3, 0.34641), 1e-4);

  // 95 % of marks that are placed so lie within 1.96 standard deviations of the true distance
  std::mt19937 dice(5);
  std::normal_distribution<double> placing(0.0, 0.3);
  std::uniform_real_distribution<double> voxel(-0.2, 0.2);
  const Eigen::Matrix3d cubes = voxels({0.4, 0.4, 0.4});
  int within = 0;
  constexpr int trials = 4000;
  for (int k = 0; k < trials; ++k) {
    const std::vector<Vector3d> mark{
        {3.0 + placing(dice) + voxel(dice), placing(dice) + voxel(dice), 9 + placing(dice)}};
    const DistanceToLine found = distanceToLine(mark, line, cubes);
    within += std::fabs(found.distance_mm - 3.0) <= 1.96 * found.sd_mm ? 1 : 0;
  }
  EXPECT_NEAR(double(within) / trials, 0.95, test::tolerance(0.012, "three sigma of 4000 trials"));
}

}  // namespace
}  // namespace perilymph::ct
