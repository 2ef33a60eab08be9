// SPDX-License-Identifier: BSD-3-Clause

// Angles of an insertion to the basal turn, against constructions with points and spherical coordinates
// in spirals whose tangent at the round window is known.

#include "perilymph/anatomy/Approach.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <random>

#include "perilymph/anatomy/MeanScala.h"
#include "perilymph/test/Tolerance.h"

namespace perilymph::anatomy {
namespace {

using Eigen::Vector3d;

// What the window and the reports state.
const double stated_deg = 0.1;

/// A round duct whose center line has these slopes at 0 degrees: outward and up, per radian, in units of
/// its radius there. Both 0: a torus.
ScalaTympani spiral(double outward, double up)
{
  SectionTables tables;
  tables.name = "spiral";
  tables.step = degrees(5).si();
  tables.directions = 16;
  constexpr int sections = 120;
  for (int i = 0; i <= sections; ++i) {
    const double angle = tables.step * i;
    tables.centerRadius.push_back(4.5e-3 * (1.0 + outward * angle));
    tables.centerHeight.push_back(4.5e-3 * up * angle);
    tables.wallRadius.insert(tables.wallRadius.end(), 16, i < sections ? 0.5e-3 : 0.05e-3);
    tables.membraneInner.push_back(-0.1e-3);
    tables.membraneOuter.push_back(0.1e-3);
    tables.membraneHeight.push_back(0.4e-3);
    tables.planRadius.push_back(tables.centerRadius.back());
  }
  tables.leadIn = 1e-3;
  return ScalaTympani(tables);
}

/// Spirals with their tangent into the cochlea at the round window, which is (outward, 1, up).
struct KnownSpiral {
  double outward, up;
  Vector3d tangent() const { return Vector3d(outward, 1.0, up).normalized(); }
};
constexpr KnownSpiral knownSpirals[] = {{0.0, 0.0}, {-0.05, 0.0}, {0.0, 0.1}, {-0.08, -0.15}};

/// Degrees between two vectors, by the law of cosines on the sides of their triangle.
double between_deg(const Vector3d& one, const Vector3d& other)
{
  const double a = one.norm(), b = other.norm(), c = (one - other).norm();
  return std::acos(std::clamp((a * a + b * b - c * c) / (2.0 * a * b), -1.0, 1.0)) * 180.0 / pi;
}

TEST(BasalTurnAngles, AreZeroAlongTheTangentOfTheCenterLine)
{
  for (const KnownSpiral& known : knownSpirals) {
    const ScalaTympani scala = spiral(known.outward, known.up);
    const Entry entry = scala.entry();
    EXPECT_LT(between_deg(directionOf({}, entry), known.tangent()),
              test::tolerance(stated_deg, "as stated"));
    const BasalTurnAngles angles = anglesToBasalTurn({}, entry);
    EXPECT_NEAR(inDegrees(angles.inPlane), 0.0, 1e-9);
    EXPECT_NEAR(inDegrees(angles.outOfPlane), 0.0, 1e-9);
  }
}

TEST(BasalTurnAngles, AreLongitudeAndLatitudeInATorus)
{
  // into the cochlea along +y, lateral wall toward +x, basilar membrane toward +z
  const Entry entry = spiral(0.0, 0.0).entry();
  for (double longitude_deg = -30; longitude_deg <= 30; longitude_deg += 7.5)
    for (double latitude_deg = -30; latitude_deg <= 30; latitude_deg += 7.5) {
      const double longitude = longitude_deg * pi / 180.0, latitude = latitude_deg * pi / 180.0;
      const Vector3d into(std::sin(longitude) * std::cos(latitude),
                          std::cos(longitude) * std::cos(latitude), std::sin(latitude));
      const BasalTurnAngles angles = anglesToBasalTurn(approachAlong(into, entry), entry);
      EXPECT_NEAR(inDegrees(angles.inPlane), longitude_deg, 1e-9);
      EXPECT_NEAR(inDegrees(angles.outOfPlane), latitude_deg, 1e-9);
    }
}

TEST(BasalTurnAngles, AgreeWithTheShadowsOfTheLineOnThePlaneAndOnTheAxis)
{
  std::mt19937 dice(7);
  std::uniform_real_distribution<double> angle(-30.0, 30.0);
  for (const KnownSpiral& known : knownSpirals) {
    const ScalaTympani scala = spiral(known.outward, known.up);
    const Entry entry = scala.entry();
    const Vector3d tangent = known.tangent(), axis = Vector3d::UnitZ();
    for (int k = 0; k < 200; ++k) {
      // a line by two points: 15 mm outside and 2 mm behind the opening, turned at random
      const Vector3d into =
          Eigen::AngleAxisd(angle(dice) * pi / 180.0, axis) *
          (Eigen::AngleAxisd(angle(dice) * pi / 180.0, Vector3d::UnitX()) * tangent);
      const Vector3d outer = entry.origin_W - 15e-3 * into, inner = entry.origin_W + 2e-3 * into;
      const Vector3d line = inner - outer;
      const BasalTurnAngles angles = anglesToBasalTurn(approachAlong(line, entry), entry);
      const Vector3d shadow(line.x(), line.y(), 0.0), tangentShadow(tangent.x(), tangent.y(), 0.0);
      EXPECT_NEAR(std::fabs(inDegrees(angles.inPlane)), between_deg(shadow, tangentShadow),
                  test::tolerance(stated_deg, "as stated"));
      EXPECT_NEAR(inDegrees(angles.outOfPlane),
                  between_deg(tangent, axis) - between_deg(line, axis),
                  test::tolerance(stated_deg, "as stated"));
      // toward the lateral wall: the tip comes to lie farther from the axis than along the tangent
      const Vector3d tip = entry.origin_W + 1e-3 * into, along = entry.origin_W + 1e-3 * tangent;
      const bool isClear = between_deg(shadow, tangentShadow) > 1.0 &&
                           std::fabs(inDegrees(angles.outOfPlane)) < 10.0;
      if (!isClear) continue;
      EXPECT_EQ(angles.inPlane.si() > 0.0, tip.head<2>().norm() > along.head<2>().norm());
    }
  }
}

TEST(BasalTurnAngles, GiveTheApproachBack)
{
  const auto mean = buildMean(millimeters(1));
  ASSERT_TRUE(mean) << mean.error().message;
  const Entry entries[] = {spiral(-0.08, -0.15).entry(), (*mean)->entry()};
  for (const Entry& entry : entries)
    for (double tilt_deg = -30; tilt_deg <= 30; tilt_deg += 6)
      for (double turn_deg = -30; turn_deg <= 30; turn_deg += 6) {
        const Approach approach{degrees(tilt_deg), degrees(turn_deg)};
        const Approach again = approachAt(anglesToBasalTurn(approach, entry), entry);
        EXPECT_NEAR(inDegrees(again.tilt), tilt_deg, 1e-9);
        EXPECT_NEAR(inDegrees(again.turn), turn_deg, 1e-9);
        const Approach along = approachAlong(2.5 * directionOf(approach, entry), entry);
        EXPECT_NEAR(inDegrees(along.tilt), tilt_deg, 1e-9);
        EXPECT_NEAR(inDegrees(along.turn), turn_deg, 1e-9);
      }
}

TEST(AnApproach, IsATiltUpOfTheTurnedLine)
{
  // in a torus a tilt of 90 degrees points along the axis, whatever the turn
  const Entry entry = spiral(0.0, 0.0).entry();
  EXPECT_LT((directionOf({degrees(90), degrees(20)}, entry) - Vector3d::UnitZ()).norm(), 1e-12);
  EXPECT_LT((directionOf({degrees(0), degrees(90)}, entry) - Vector3d::UnitX()).norm(), 1e-12);
}

TEST(AnApproach, IsLimitedToWhatAScenarioHasInHundredthsOfADegree)
{
  const Approach limited = withinLimits({degrees(12.3442), degrees(-47.0)});
  EXPECT_DOUBLE_EQ(inDegrees(limited.tilt), 12.34);
  EXPECT_DOUBLE_EQ(inDegrees(limited.turn), -30.0);
}

}  // namespace
}  // namespace perilymph::anatomy
