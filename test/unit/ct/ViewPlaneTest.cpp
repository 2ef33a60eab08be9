// SPDX-License-Identifier: BSD-3-Clause

// The planes in which a CT is looked at, against the conventions of radiology.

#include "perilymph/ct/ViewPlane.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace perilymph::ct {
namespace {

using Eigen::Vector3d;

TEST(PatientPlanes, AreSeenFromTheFeetFromTheFrontAndFromTheLeft)
{
  const auto planes = patientPlanes(Vector3d(1, 2, 3));
  const auto letters = [&](std::size_t k) {
    return std::array{directionLetters(planes[k].right_P), directionLetters(-planes[k].down_P),
                      directionLetters(planes[k].away_P())};
  };
  EXPECT_EQ(letters(0), (std::array<std::string, 3>{"L", "A", "S"}));
  EXPECT_EQ(letters(1), (std::array<std::string, 3>{"L", "S", "P"}));
  EXPECT_EQ(letters(2), (std::array<std::string, 3>{"P", "S", "R"}));
}

TEST(DirectionLetters, NameTheLargestComponentFirstAndLeaveSmallOnesOut)
{
  EXPECT_EQ(directionLetters(Vector3d(0.1, -0.99, 0.1)), "A");
  EXPECT_EQ(directionLetters(Vector3d(0.5, 0.3, -0.81)), "ILP");
  EXPECT_EQ(directionLetters(Vector3d(-0.8, 0.0, 0.6)), "RS");
}

TEST(ViewPlane, FindsTheSamePointInThePictureAndInThePatient)
{
  const ViewPlane plane{{10, -20, 5}, Vector3d(0.6, 0.8, 0), Vector3d(-0.8, 0.6, 0)};
  const Vector3d point = plane.atPicture({3.0, -2.0});
  EXPECT_LT((plane.inPicture(point) - Eigen::Vector2d(3.0, -2.0)).norm(), 1e-12);
  EXPECT_NEAR(plane.behind(point), 0.0, 1e-12);
  EXPECT_NEAR(plane.behind(point + 0.7 * plane.away_P()), 0.7, 1e-12);
}

/// A tube about the axis z of a frame: radius 4 mm at height 1 mm, with rings of a circle of 0.5 mm.
CochleaMeasures ringShapedCochlea(bool isMirrored)
{
  CochleaMeasures measures;
  const double turn = std::numbers::pi / 180.0;
  const Vector3d origin(30, -10, 5), z = Vector3d(1, 2, 2) / 3.0, x = Vector3d(2, 1, -2) / 3.0;
  const Vector3d y = isMirrored ? Vector3d(-z.cross(x)) : Vector3d(z.cross(x));
  measures.axis_P = z;
  measures.center_P = origin;
  measures.axes_PW.col(0) = x;
  measures.axes_PW.col(1) = y;
  measures.axes_PW.col(2) = z;
  measures.roundWindow_P = origin + 4.5 * x;
  measures.wallPointsPerRing = 24;
  constexpr int rings = 90, n = 24;
  for (int ring = 0; ring < rings; ++ring)
    for (int k = 0; k < n; ++k) {
      const double angle = 4.0 * turn * ring, around = 360.0 / n * turn * k;
      const double radius = 4.0 + 0.5 * std::cos(around), height = 1.0 + 0.5 * std::sin(around);
      measures.wall_P.push_back(origin + radius * (std::cos(angle) * x + std::sin(angle) * y) +
                                height * z);
    }
  for (int ring = 0; ring + 1 < rings; ++ring)
    for (int k = 0; k < n; ++k) {
      const int a = ring * n + k, b = ring * n + (k + 1) % n;
      measures.wallTriangles.push_back({a, b, a + n});
      measures.wallTriangles.push_back({b, b + n, a + n});
    }
  return measures;
}

TEST(CochlearView, IsSquareToTheModiolusWithTheApexTowardTheViewerAndTheWindowBelow)
{
  for (const bool isMirrored : {false, true}) {
    const CochleaMeasures measures = ringShapedCochlea(isMirrored);
    const auto planes = cochlearPlanes(measures, measures.center_P);
    EXPECT_NEAR(planes[0].away_P().dot(measures.axis_P), -1.0, 1e-12);
    EXPECT_NEAR(planes[0].inPicture(measures.roundWindow_P).x(), 0.0, 1e-12);
    EXPECT_NEAR(planes[0].inPicture(measures.roundWindow_P).y(), 4.5, 1e-12);
    for (const std::size_t k : {1u, 2u}) {
      EXPECT_NEAR(planes[k].away_P().dot(measures.axis_P), 0.0, 1e-12);
      EXPECT_NEAR(planes[k].down_P.dot(measures.axis_P), -1.0, 1e-12);
    }
    // along A the window lies in the plane, along B the plane is square to A
    EXPECT_NEAR(planes[1].behind(measures.roundWindow_P), 0.0, 1e-12);
    EXPECT_NEAR(std::fabs(planes[2].behind(measures.roundWindow_P)), 4.5, 1e-12);
  }
}

TEST(CochlearView, OpensInTheMiddleOfTheBasalTurn)
{
  const CochleaMeasures measures = ringShapedCochlea(false);
  const Vector3d expected = measures.center_P + measures.axis_P;
  EXPECT_LT((basalTurnCenter_P(measures) - expected).norm(), 1e-9);
}

TEST(WallOutline, OfARingIsTwoCirclesInThePlaneOfTheRing)
{
  const CochleaMeasures measures = ringShapedCochlea(true);
  const auto plane = cochlearPlanes(measures, measures.center_P + measures.axis_P)[0];
  const auto lines = wallOutline(measures, plane);
  ASSERT_GT(lines.size(), 100u);
  int inner = 0, outer = 0;
  for (const PictureLine& line : lines)
    for (const Eigen::Vector2d& end : line) {
      const double radius = end.norm();
      // corners of the mesh lie on the circles, the middles of its edges 3 um within
      (radius < 4.0 ? inner : outer) += 1;
      EXPECT_NEAR(radius, radius < 4.0 ? 3.5 : 4.5, 0.01);
    }
  EXPECT_GT(inner, 100);
  EXPECT_GT(outer, 100);
}

TEST(WallOutline, IsEmptyBesideTheCochlea)
{
  const CochleaMeasures measures = ringShapedCochlea(false);
  EXPECT_TRUE(
      wallOutline(measures, cochlearPlanes(measures, measures.center_P + 5.0 * measures.axis_P)[0])
          .empty());
}

}  // namespace
}  // namespace perilymph::ct
