// SPDX-License-Identifier: BSD-3-Clause

// The wall query against a brute-force search over a dense sampling of the wall, and closed forms.

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include "lumen/PlainLumens.h"
#include "perilymph/anatomy/MeanScala.h"
#include "perilymph/anatomy/Patient.h"
#include "perilymph/test/Tolerance.h"
#include "sources/ClarkScala.h"

namespace perilymph::anatomy {
namespace {

constexpr double everywhere = 1.0;  // a reach beyond every wall [m]

WallPoint ask(const Lumen& lumen, const Eigen::Vector3d& point, LumenTrack track = {},
              double reach = everywhere)
{
  WallPoint wall;
  lumen.nearestWall({&point, 1}, {&reach, 1}, {&track, 1}, {&wall, 1});
  return wall;
}

LumenTrack trackAt(double angle) { return {false, angle, {std::cos(angle), std::sin(angle)}}; }

/// Distance from a point to the wall, by search over a fine grid around the point's own section.
double bruteDistance(const ScalaTympani& scala, const Eigen::Vector3d& point, double angle)
{
  double nearest = 1e9;
  double bestAngle = angle, bestDirection = 0.0;
  double angleSpan = 0.35, directionSpan = pi;
  for (int level = 0; level < 6; ++level) {
    constexpr int steps = 60;
    const double centerAngle = bestAngle, centerDirection = bestDirection;
    for (int i = -steps; i <= steps; ++i)
      for (int k = -steps; k <= steps; ++k) {
        const double a = centerAngle + angleSpan * i / steps;
        if (a < 0.0) continue;
        const double d = centerDirection + directionSpan * k / steps;
        const double distance = (scala.wall_W(a, d) - point).norm();
        if (distance < nearest) {
          nearest = distance;
          bestAngle = a;
          bestDirection = d;
        }
      }
    angleSpan *= 0.15;
    directionSpan *= 0.15;
  }
  return nearest;
}

/// The lumen of every anatomy, through the same distance table.
class LumenOf : public testing::TestWithParam<const char*> {
protected:
  /// Built once for all cases.
  static std::shared_ptr<const ScalaTympani> built(const std::string& anatomy)
  {
    static const auto mean = buildMean(millimeters(1)), clark = buildClark(millimeters(1));
    static const auto published = buildPublished({}, millimeters(1));
    if (anatomy == "published") return published;
    return anatomy == "mean" ? *mean : *clark;
  }

  std::shared_ptr<const ScalaTympani> scala = built(GetParam());

  /// A point inside the section at an angle, at a fraction of the distance to the wall.
  Eigen::Vector3d inside(double angle, double direction, double fraction) const
  {
    return scala->center_W(angle) +
           fraction * (scala->wall_W(angle, direction) - scala->center_W(angle));
  }
};

TEST_P(LumenOf, MeasuresTheDistanceToTheNearestWall)
{
  std::mt19937 random(3);
  std::uniform_real_distribution<double> angles(degrees(25).si(), degrees(800).si());
  std::uniform_real_distribution<double> directions(0.0, 2.0 * pi);
  std::uniform_real_distribution<double> fractions(0.3, 1.0);
  std::vector<double> errors;
  for (int i = 0; i < 120; ++i) {
    const double angle = angles(random);
    const Eigen::Vector3d point = inside(angle, directions(random), fractions(random));
    const WallPoint wall = ask(*scala, point, trackAt(angle));
    ASSERT_TRUE(wall.isNear);
    errors.push_back(std::fabs(wall.distance - bruteDistance(*scala, point, angle)));
  }
  std::sort(errors.begin(), errors.end());
  // Within a grid step of a ridge the table is smoothed: the last tenth may deviate more.
  EXPECT_LT(errors[errors.size() / 2], test::tolerance(4e-6, "table's smoothing"));
  EXPECT_LT(errors[errors.size() * 9 / 10], test::tolerance(15e-6, "rounded ridges"));
  EXPECT_LT(errors.back(), test::tolerance(40e-6, "rounded ridges"));
}

/// A round duct of 1.2 mm on a spiral that hardly narrows: the plane of its opening is radial, so that it
/// cuts the spiral after half a turn.
ScalaTympani roundSpiral()
{
  SectionTables tables;
  tables.name = "round spiral";
  tables.step = degrees(5).si();
  tables.directions = 32;
  for (int i = 0; i <= 144; ++i) {
    const double angle = tables.step * i;
    tables.centerRadius.push_back(4.5e-3 * std::exp(-0.06 * angle));
    tables.centerHeight.push_back(0.25e-3 * angle);
    tables.wallRadius.insert(tables.wallRadius.end(), 32, i < 144 ? 0.6e-3 : 0.05e-3);
    tables.membraneInner.push_back(-0.1e-3);
    tables.membraneOuter.push_back(0.1e-3);
    tables.membraneHeight.push_back(0.55e-3);
    tables.planRadius.push_back(tables.centerRadius.back());
  }
  return ScalaTympani(tables);
}

TEST(LumenBehindItsOpening, HasAWallWhereThePlaneOfTheOpeningCutsALaterTurn)
{
  const ScalaTympani scala = roundSpiral();
  const Entry entry = scala.entry();
  int cut = 0;
  for (double angle_deg = 150; angle_deg < 360; angle_deg += 10) {
    const double angle = degrees(angle_deg).si();
    const Eigen::Vector3d point = 0.4 * scala.center_W(angle) + 0.6 * scala.wall_W(angle, 0.0);
    LumenTrack track = trackAt(angle);
    scala.follow(point, track);
    EXPECT_NEAR(track.angle, angle, 1e-9);
    EXPECT_GT(behindOpening(entry, point, track), 0.0);
    const WallPoint wall = ask(scala, point, trackAt(angle));
    ASSERT_TRUE(wall.isNear) << angle_deg;
    EXPECT_NEAR(wall.distance, bruteDistance(scala, point, angle),
                test::tolerance(40e-6, "rounded ridges"))
        << angle_deg;
    if ((entry.origin_W - point).dot(entry.out_W) > 0.0) continue;
    ++cut;
    // a point of which nothing says that it came by that turn is in front of the opening
    EXPECT_FALSE(ask(scala, point).isNear) << angle_deg;
  }
  EXPECT_GT(cut, 8);
}

TEST_P(LumenOf, IsZeroOnTheWallAndNegativeBeyond)
{
  for (double angle_deg = 10; angle_deg < 850; angle_deg += 40)
    for (const double direction : {0.5, 1.5, 2.6, 3.6, 4.7, 5.8}) {
      const double angle = degrees(angle_deg).si();
      EXPECT_NEAR(ask(*scala, inside(angle, direction, 1.0), trackAt(angle)).distance, 0.0,
                  test::tolerance(12e-6, "table's smoothing"))
          << angle_deg << " deg, direction " << direction;
      EXPECT_LT(ask(*scala, inside(angle, direction, 1.15), trackAt(angle)).distance, 0.0);
      EXPECT_GT(ask(*scala, inside(angle, direction, 0.85), trackAt(angle)).distance, 0.0);
    }
}

TEST_P(LumenOf, GivesTheGradientOfItsDistance)
{
  std::mt19937 random(5);
  std::uniform_real_distribution<double> angles(degrees(2).si(), degrees(800).si());
  std::uniform_real_distribution<double> directions(0.0, 2.0 * pi);
  std::uniform_real_distribution<double> fractions(0.4, 1.1);
  constexpr double nudge = 1e-7;
  int tooLong = 0;
  for (int i = 0; i < 300; ++i) {
    const double angle = angles(random);
    const Eigen::Vector3d point = inside(angle, directions(random), fractions(random));
    const WallPoint wall = ask(*scala, point, trackAt(angle));
    for (int axis = 0; axis < 3; ++axis) {
      const Eigen::Vector3d step = nudge * Eigen::Vector3d::Unit(axis);
      const double slope = (ask(*scala, point + step, trackAt(angle)).distance -
                            ask(*scala, point - step, trackAt(angle)).distance) /
                           (2.0 * nudge);
      EXPECT_NEAR(wall.normal_W[axis], slope, 1e-4);
    }
    tooLong += wall.normal_W.norm() > 1.06 ? 1 : 0;
  }
  // Where an inner wall is 0.2 mm from the axis, the nearest wall is 20 degrees away and the table
  // is coarse: one point in a hundred may deviate.
  EXPECT_LE(tooLong, 3);
}

TEST_P(LumenOf, GivesTheHessianOfItsDistance)
{
  std::mt19937 random(7);
  std::uniform_real_distribution<double> angles(degrees(2).si(), degrees(800).si());
  std::uniform_real_distribution<double> directions(0.0, 2.0 * pi);
  std::uniform_real_distribution<double> fractions(0.4, 1.1);
  constexpr double nudge = 1e-8;
  int compared = 0;
  for (int i = 0; i < 300; ++i) {
    const double angle = angles(random);
    // every tenth in the lead-in
    const bool isBefore = i % 10 == 0;
    const Eigen::Vector3d point =
        inside(isBefore ? 0.0 : angle, directions(random), fractions(random)) +
        (isBefore ? Eigen::Vector3d(0.5e-3 * scala->entry().out_W) : Eigen::Vector3d::Zero());
    const LumenTrack track = isBefore ? LumenTrack{} : trackAt(angle);
    const WallPoint wall = ask(*scala, point, track);
    if (!wall.isNear || !(wall.trustRadius > 0.0)) continue;
    ++compared;
    const double size = wall.hessian_W.norm() + 100.0;
    EXPECT_LT((wall.hessian_W - wall.hessian_W.transpose()).norm(), 1e-9 * size);
    for (int axis = 0; axis < 3; ++axis) {
      const Eigen::Vector3d step = nudge * Eigen::Vector3d::Unit(axis);
      const Eigen::Vector3d change =
          (ask(*scala, point + step, track).normal_W - ask(*scala, point - step, track).normal_W) /
          (2.0 * nudge);
      EXPECT_LT((wall.hessian_W.col(axis) - change).norm(), 2e-3 * size)
          << inDegrees(Angle::fromSi(angle)) << " deg, axis " << axis;
    }
  }
  EXPECT_GT(compared, 200);
}

TEST_P(LumenOf, IsKnownToSecondOrderWithinItsTrustRadius)
{
  std::mt19937 random(17);
  std::uniform_real_distribution<double> angles(degrees(1).si(), degrees(800).si());
  std::uniform_real_distribution<double> directions(0.0, 2.0 * pi);
  std::uniform_real_distribution<double> fractions(0.3, 1.05);
  std::normal_distribution<double> component(0.0, 1.0);
  std::vector<double> errors, slopes, radii;
  for (int i = 0; i < 20000; ++i) {
    const double angle = angles(random);
    const Eigen::Vector3d point = inside(angle, directions(random), fractions(random));
    const WallPoint wall = ask(*scala, point, trackAt(angle), 0.4e-3);
    if (!wall.isNear) continue;
    radii.push_back(wall.trustRadius);
    const Eigen::Vector3d way(component(random), component(random), component(random));
    const Eigen::Vector3d moved = wall.trustRadius * way.normalized();
    const WallPoint there = ask(*scala, point + moved, trackAt(angle), 0.4e-3 + wall.trustRadius);
    ASSERT_TRUE(there.isNear);
    const Eigen::Vector3d turned = wall.hessian_W * moved;
    errors.push_back(
        std::fabs(there.distance - (wall.distance + (wall.normal_W + 0.5 * turned).dot(moved))));
    slopes.push_back((there.normal_W - wall.normal_W - turned).norm());
  }
  for (std::vector<double>* list : {&errors, &slopes, &radii})
    std::sort(list->begin(), list->end());
  const auto at = [](const std::vector<double>& list, double part) {
    return list[static_cast<std::size_t>(part * static_cast<double>(list.size() - 1))];
  };
  std::printf(
      "%s: radius %.1f um (median), %.1f um (tenth); error %.2f nm (median), %.2f nm (99 %%), "
      "%.2f nm (largest); of the normal %.1e (99 %%), %.1e (largest)\n",
      scala->name().c_str(), 1e6 * at(radii, 0.5), 1e6 * at(radii, 0.1), 1e9 * at(errors, 0.5),
      1e9 * at(errors, 0.99), 1e9 * errors.back(), at(slopes, 0.99), slopes.back());
  EXPECT_GT(errors.size(), 5000u);
  EXPECT_LT(at(errors, 0.99), 10e-9);
  // next to a ridge of the mean anatomy, where the third derivative jumps between cells
  EXPECT_LT(errors.back(), test::tolerance(40e-9, "one point in thousands"));
  EXPECT_GT(at(radii, 0.5), 2e-6);
}

TEST_P(LumenOf, ChangesSmoothlyAlongTheDuct)
{
  // A point moves along the lumen, off center, from the lead-in on: distance and normal have no
  // steps, not even where the straight lead-in meets the spiral.
  const Entry entry = scala->entry();
  LumenTrack track;
  double lastDistance = 0.0;
  Eigen::Vector3d lastNormal = Eigen::Vector3d::Zero();
  bool hasLast = false;
  for (double s = 0.1e-3; s < 4e-3; s += 0.0025e-3) {
    const Eigen::Vector3d point = entry.origin_W - s * entry.out_W + 0.3e-3 * entry.outward_W;
    WallPoint wall;
    const double reach = everywhere;
    scala->nearestWall({&point, 1}, {&reach, 1}, {&track, 1}, {&wall, 1});
    ASSERT_TRUE(wall.isNear);
    if (hasLast) {
      EXPECT_NEAR(wall.distance, lastDistance, 0.003e-3) << s;
      // At the end of the lead-in the normal may change by 0.04; a corner would change it by at
      // least 0.1.
      EXPECT_LT((wall.normal_W - lastNormal).norm(), 0.05) << s;
    }
    lastDistance = wall.distance;
    lastNormal = wall.normal_W;
    hasLast = true;
  }
}

TEST_P(LumenOf, RemembersItsTurn)
{
  // the same point of the plane, one turn apart: the track selects the wall
  const double angle = degrees(100).si();
  const Eigen::Vector3d first = scala->center_W(angle);
  const Eigen::Vector3d second = scala->center_W(angle + 2 * pi);
  EXPECT_GT(ask(*scala, first, trackAt(angle)).distance, 0.3e-3);
  EXPECT_GT(ask(*scala, second, trackAt(angle + 2 * pi)).distance, 0.2e-3);
  EXPECT_LT(ask(*scala, second, trackAt(angle)).distance, 0.0);
}

TEST_P(LumenOf, SeesNoWallOutsideTheOpening)
{
  const Entry entry = scala->entry();
  for (const double out_mm : {0.01, 1.0, 20.0}) {
    const Eigen::Vector3d point = entry.origin_W + out_mm / 1e3 * entry.out_W;
    EXPECT_FALSE(ask(*scala, point).isNear) << out_mm;
  }
}

TEST_P(LumenOf, ClosesAtTheApex)
{
  const double end = scala->lastAngle().si();
  const Eigen::Vector3d point = scala->center_W(end - 0.1);
  const Eigen::Vector3d beyond =
      scala->center_W(end) + 0.2e-3 * Eigen::Vector3d(-std::sin(end), std::cos(end), 0.0);
  EXPECT_GT(ask(*scala, point, trackAt(end - 0.1)).distance, 0.0);
  EXPECT_LT(ask(*scala, beyond, trackAt(end)).distance, -0.15e-3);
}

TEST_P(LumenOf, ReportsNoWallBeyondTheReach)
{
  const double angle = degrees(60).si();
  const WallPoint wall = ask(*scala, scala->center_W(angle), trackAt(angle), 0.1e-3);
  EXPECT_FALSE(wall.isNear);
}

TEST_P(LumenOf, SeesNoWallWithinTheClearanceItGave)
{
  // A point that moves by less than the clearance must not get within reach of the wall.
  std::mt19937 random(13);
  std::uniform_real_distribution<double> angles(0.0, scala->lastAngle().si());
  std::uniform_real_distribution<double> directions(0.0, 2.0 * pi);
  std::uniform_real_distribution<double> fractions(0.0, 0.9);
  std::normal_distribution<double> component(0.0, 1.0);
  constexpr double reach = 0.2e-3;
  int far = 0;
  for (int i = 0; i < 400; ++i) {
    const double angle = angles(random);
    // every fourth in the lead-in or outside the opening
    const bool isBefore = i % 4 == 0;
    const Eigen::Vector3d point =
        isBefore ? Eigen::Vector3d(scala->center_W(0.0) +
                                   3e-3 * fractions(random) * scala->entry().out_W)
                 : inside(angle, directions(random), fractions(random));
    const LumenTrack track = isBefore ? LumenTrack{} : trackAt(angle);
    const WallPoint wall = ask(*scala, point, track, reach);
    if (wall.isNear || wall.clearance <= 0.0) continue;
    ++far;
    for (int k = 0; k < 20; ++k) {
      const Eigen::Vector3d way(component(random), component(random), component(random));
      const Eigen::Vector3d moved = point + 0.999 * wall.clearance * way.normalized();
      EXPECT_FALSE(ask(*scala, moved, track, reach).isNear) << inDegrees(Angle::fromSi(angle));
    }
  }
  EXPECT_GT(far, 100);
}

TEST_P(LumenOf, FindsNoWallForInvalidPoints)
{
  const double bad = std::nan("");
  EXPECT_FALSE(ask(*scala, {bad, bad, bad}).isNear);
  EXPECT_FALSE(ask(*scala, {0.0, 0.0, 1e-3}, trackAt(3.0)).isNear);
}

TEST_P(LumenOf, KnowsItsMembrane)
{
  const double angle = degrees(200).si();
  const Eigen::Vector3d below = scala->membrane_W(angle, 0.5) - Eigen::Vector3d(0, 0, 0.1e-3);
  EXPECT_TRUE(ask(*scala, below, trackAt(angle)).onMembrane);
  const Eigen::Vector3d outer = inside(angle, 0.0, 0.9);
  EXPECT_FALSE(ask(*scala, outer, trackAt(angle)).onMembrane);
}

INSTANTIATE_TEST_SUITE_P(Anatomies, LumenOf, testing::Values("published", "mean", "clark"),
                         [](const auto& anatomy) { return std::string(anatomy.param); });

TEST(CircularDuct, HasTheDistanceAndTurningOfATorus)
{
  const CircularDuct duct(1e-3, 5e-3, 2e-3);
  const double angle = 1.1;
  // a point 0.6 mm off the axis, toward the outer wall
  const double r = 5.6e-3;
  const Eigen::Vector3d point(r * std::cos(angle) - 5e-3, 0.0, -r * std::sin(angle) - 2e-3);
  const WallPoint wall = ask(duct, point, trackAt(angle));
  EXPECT_NEAR(wall.distance, 0.4e-3, 1e-12);
  const Eigen::Vector3d outward(std::cos(angle), 0.0, -std::sin(angle));
  EXPECT_NEAR(wall.normal_W.dot(outward), -1.0, 1e-12);
  // Principal radii of the parallel surface: 0.6 mm around the section, 5.6 mm along the duct.
  EXPECT_NEAR(wall.shapeOperator_W(1, 1), 1.0 / 0.6e-3, 1e-6);
  const Eigen::Vector3d along(-std::sin(angle), 0.0, -std::cos(angle));
  EXPECT_NEAR(along.dot(wall.shapeOperator_W * along), 1.0 / 5.6e-3, 1e-6);
}

}  // namespace
}  // namespace perilymph::anatomy
