// SPDX-License-Identifier: BSD-3-Clause

// Distances and angles between points of a CT, with the error of placing them.

#include "perilymph/ct/Markups.h"

#include <gmock/gmock.h>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <cmath>
#include <numbers>
#include <random>

namespace perilymph::ct {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using testing::HasSubstr;

/// A rotation by a unit quaternion of four normal numbers: uniform over all rotations.
Matrix3d anyRotation(std::mt19937_64& random)
{
  std::normal_distribution<double> normal;
  return Eigen::Quaterniond(normal(random), normal(random), normal(random), normal(random))
      .normalized()
      .toRotationMatrix();
}

Vector3d anyPoint(std::mt19937_64& random, double reach_mm)
{
  std::uniform_real_distribution<double> uniform(-reach_mm, reach_mm);
  return {uniform(random), uniform(random), uniform(random)};
}

/// Edges of an oblique, anisotropic voxel, left-handed every second time.
Matrix3d anyVoxel(std::mt19937_64& random)
{
  std::uniform_real_distribution<double> edge(0.1, 0.9);
  Matrix3d edges =
      anyRotation(random) * Vector3d(edge(random), edge(random), edge(random)).asDiagonal();
  if (random() % 2 == 0) edges.col(2) = -edges.col(2);
  return edges;
}

/// The markup in a body that was moved.
Markup moved(Markup markup, const Matrix3d& rotation, const Vector3d& by)
{
  for (Vector3d& point : markup.points_P) point = rotation * point + by;
  return markup;
}

/// The standard deviation of a value when each point is anywhere in a voxel about its place.
double sampledSd(const Markup& markup, const Matrix3d& edges, int count)
{
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> half(-0.5, 0.5);
  double sum = 0.0, squares = 0.0;
  const double about = valueOf(markup, edges)->value;
  for (int k = 0; k < count; ++k) {
    Markup placed = markup;
    for (Vector3d& point : placed.points_P)
      point += edges * Vector3d(half(random), half(random), half(random));
    const double error = valueOf(placed, edges)->value - about;
    sum += error;
    squares += error * error;
  }
  return std::sqrt(squares / count - sum * sum / count / count);
}

TEST(MarkupDistance, IsThatOfPythagorasInAnyPose)
{
  std::mt19937_64 random(1);
  const Markup markup{MarkupKind::distance, {Vector3d(1, 2, 3), Vector3d(4, 6, 15)}};  // 3, 4, 12
  for (int k = 0; k < 100; ++k) {
    const Markup any = moved(markup, anyRotation(random), anyPoint(random, 300));
    EXPECT_NEAR(valueOf(any, anyVoxel(random))->value, 13.0, 1e-12 * 300);
  }
}

TEST(MarkupAngle, IsThatOfItsConstructionInAnyPose)
{
  std::mt19937_64 random(2);
  for (int angle_deg = 0; angle_deg <= 180; angle_deg += 5) {
    const double angle = angle_deg * std::numbers::pi / 180.0;
    const Vector3d vertex(5, -7, 11);
    const Markup markup{MarkupKind::angle,
                        {vertex + Vector3d(3, 0, 0), vertex,
                         vertex + 8 * Vector3d(std::cos(angle), std::sin(angle), 0)}};
    const Markup any = moved(markup, anyRotation(random), anyPoint(random, 300));
    // where the sides are one line the angle is the rounding of a place, 1e-13 mm, over 3 mm
    EXPECT_NEAR(valueOf(any, anyVoxel(random))->value, angle_deg, 1e-10);
  }
}

TEST(MarkupDistance, HasTheErrorOfTwoUniformPlacesAlongIt)
{
  std::mt19937_64 random(3);
  // along an edge e of a voxel in any pose: two errors of the variance e²/12
  for (int k = 0; k < 20; ++k) {
    const Matrix3d edges = anyVoxel(random);
    for (int axis = 0; axis < 3; ++axis) {
      const Vector3d from = anyPoint(random, 100);
      const Markup markup{MarkupKind::distance, {from, from + 30 * edges.col(axis)}};
      EXPECT_NEAR(valueOf(markup, edges)->sd, edges.col(axis).norm() / std::sqrt(6.0), 1e-12);
    }
  }
  // a cube's error is the same in every direction
  const Matrix3d cube = 0.3 * anyRotation(random);
  for (int k = 0; k < 20; ++k) {
    const Markup markup{MarkupKind::distance, {anyPoint(random, 50), anyPoint(random, 50)}};
    EXPECT_NEAR(valueOf(markup, cube)->sd, 0.3 / std::sqrt(6.0), 1e-12);
  }
}

TEST(MarkupAngle, OfRightAnglesInACubeHasTheErrorOfItsSides)
{
  // g_p and g_q are at right angles: h² (1/p² + 1/q² + 1/p² + 1/q²)/12
  const double h = 0.4, p = 6.0, q = 9.0;
  const Markup markup{MarkupKind::angle, {Vector3d(p, 0, 0), Vector3d(0, 0, 0), Vector3d(0, q, 0)}};
  const double expected = h * std::sqrt((1 / (p * p) + 1 / (q * q)) / 6.0) * 180 / std::numbers::pi;
  EXPECT_NEAR(valueOf(markup, h * Matrix3d::Identity())->sd, expected, 1e-12);
}

TEST(MarkupValues, HaveTheErrorOfPointsThatAreSampledInTheirVoxels)
{
  std::mt19937_64 random(4);
  const int count = 20'000;  // the sampled deviation is right within 1/sqrt(2 count), 0.5 %
  for (int k = 0; k < 10; ++k) {
    const Matrix3d edges = anyVoxel(random);
    const Vector3d from = anyPoint(random, 100);
    // long against a voxel, so that the differential holds
    const auto away = [&] { return Vector3d(12 * anyRotation(random).col(0)); };
    const Markup distance{MarkupKind::distance, {from, from + away()}};
    EXPECT_NEAR(valueOf(distance, edges)->sd / sampledSd(distance, edges, count), 1.0, 0.03);
    Markup angle{MarkupKind::angle, {from + away(), from, from + away()}};
    const double size = valueOf(angle, edges)->value;
    if (size < 30.0 || size > 150.0) continue;  // near a line the angle is no linear function
    EXPECT_NEAR(valueOf(angle, edges)->sd / sampledSd(angle, edges, count), 1.0, 0.03) << size;
  }
}

TEST(MarkupAngle, WhoseSidesAreOneLineHasTheErrorOfItsWorstDirection)
{
  // flat voxels: the error across the slices is the largest, 1 mm against 0.2 mm
  const Matrix3d edges = Vector3d(0.2, 0.2, 1.0).asDiagonal();
  const double p = 5.0, q = 10.0, radian = 180 / std::numbers::pi;
  const Markup straight{MarkupKind::angle, {{-p, 0, 0}, {0, 0, 0}, {q, 0, 0}}};
  const auto by = [](double vertex, double one, double other) {
    return std::sqrt((one * one + other * other + vertex * vertex) / 12.0);
  };
  EXPECT_NEAR(valueOf(straight, edges)->value, 180.0, 1e-12);
  EXPECT_NEAR(valueOf(straight, edges)->sd, by(1 / p + 1 / q, 1 / p, 1 / q) * radian, 1e-9);
  const Markup folded{MarkupKind::angle, {{p, 0, 0}, {0, 0, 0}, {q, 0, 0}}};
  EXPECT_NEAR(valueOf(folded, edges)->value, 0.0, 1e-12);
  EXPECT_NEAR(valueOf(folded, edges)->sd, by(1 / p - 1 / q, 1 / p, 1 / q) * radian, 1e-9);
  // and is the limit of angles that open in that direction
  const Markup nearly{MarkupKind::angle, {{-p, 0, 0}, {0, 0, 0}, {q, 0, 1e-4}}};
  EXPECT_NEAR(valueOf(nearly, edges)->sd, valueOf(straight, edges)->sd, 1e-3);
}

TEST(MarkupValues, AreOfDistancesAndAnglesAlone)
{
  for (const auto& [kind, name, meaning] : markupKinds) {
    const std::vector<Vector3d> points{{0, 0, 0}, {3, 0, 0}, {3, 4, 0}};
    Markup markup{kind, {points.begin(), points.begin() + long(pointCountOf(kind).least)}, "x"};
    EXPECT_TRUE(checkMarkup(markup)) << name;
    const bool isMeasured = kind == MarkupKind::distance || kind == MarkupKind::angle;
    EXPECT_EQ(valueOf(markup, Matrix3d::Identity()).has_value(), isMeasured) << name;
    markup.points_P.pop_back();
    EXPECT_FALSE(checkMarkup(markup)) << name;
    EXPECT_FALSE(valueOf(markup, Matrix3d::Identity())) << name;
  }
}

TEST(CheckMarkup, RefusesWhatCannotBeDrawnOrKeptWithoutRepeatingTheText)
{
  const double nan = std::nan(""), infinite = std::numeric_limits<double>::infinity();
  const std::string secret = "Jane Doe";
  const Vector3d at(1, 2, 3);
  const std::vector<Markup> bad{
      {MarkupKind::distance, {at}, secret},
      {MarkupKind::distance, {at, at}, secret},
      {MarkupKind::distance, {at, {nan, 0, 0}}, secret},
      {MarkupKind::distance, {at, {0, infinite, 0}}, secret},
      {MarkupKind::distance, {at, {0, 0, 1e9}}, secret},
      {MarkupKind::distance, {at, {1, 1, 1}, {2, 2, 2}}, secret},
      {MarkupKind::angle, {at, at, {1, 1, 1}}, secret},
      {MarkupKind::angle, {at, {1, 1, 1}, {1, 1, 1}}, secret},
      {MarkupKind::note, {at}},
      {MarkupKind::note, {at}, secret + "\nand more"},
      {MarkupKind::note, {at}, secret + "\xFF"},
      {MarkupKind::note, {at}, secret + std::string(maxMarkupText, 'x')},
      {MarkupKind::facialNerve, {}, secret},
      {MarkupKind::canalWall, std::vector<Vector3d>(maxMarkupPoints + 1, at), secret}};
  for (const Markup& each : bad) {
    const auto possible = checkMarkup(each);
    ASSERT_FALSE(possible) << nameIn(markupKinds, each.kind) << each.points_P.size();
    EXPECT_THAT(possible.error().message, testing::Not(HasSubstr("Jane")));
  }
}

CtMarkups someMarkups()
{
  return {std::string(64, 'a'),
          0.3 * Matrix3d::Identity(),
          {{MarkupKind::distance, {Vector3d(1, 1, 1), Vector3d(2, 2, 2)}}}};
}

TEST(CheckMarkups, RefusesAnotherKeyAndVoxelsOfNoVolume)
{
  EXPECT_TRUE(checkMarkups(someMarkups()));
  for (const char* key : {"", "Doe, Jane", "0a1b"}) {
    CtMarkups markups = someMarkups();
    markups.seriesKey = key;
    EXPECT_FALSE(checkMarkups(markups)) << key;
  }
  const Matrix3d flat = (Matrix3d() << 1, 0, 1, 0, 1, 1, 0, 0, 0).finished();
  for (const Matrix3d& edges : {Matrix3d(Matrix3d::Zero()), flat, Matrix3d(std::nan("") * flat),
                                Matrix3d(1e3 * Matrix3d::Identity())}) {
    CtMarkups markups = someMarkups();
    markups.voxelEdges_P = edges;
    EXPECT_FALSE(checkMarkups(markups)) << edges;
  }
  CtMarkups markups = someMarkups();
  markups.markups.assign(maxMarkups + 1, markups.markups[0]);
  EXPECT_FALSE(checkMarkups(markups));
}

TEST(MarkupsOfAVolume, HaveItsKeyAndVoxelsAndSayWhatLiesOutside)
{
  std::mt19937_64 random(5);
  Eigen::Matrix4d lps_PI = Eigen::Matrix4d::Identity();
  lps_PI.topLeftCorner<3, 3>() = anyVoxel(random);
  lps_PI.topRightCorner<3, 1>() = Vector3d(100, -50, 20);
  const auto volume = CtVolume::make({4, 5, 6}, lps_PI, std::vector<std::int16_t>(120),
                                     {std::string(64, 'b'), "", "phantom"});
  ASSERT_TRUE(volume);
  CtMarkups markups = markupsOf(*volume);
  EXPECT_TRUE(checkMarkups(markups));
  EXPECT_EQ(markups.seriesKey, std::string(64, 'b'));
  EXPECT_EQ(markups.voxelEdges_P, (lps_PI.topLeftCorner<3, 3>()));
  const Vector3d in = volume->center_P(), out = volume->toLps({-0.5, 0, 0});
  markups.markups = {{MarkupKind::note, {in}, "round window"}};
  EXPECT_FALSE(outsideNote(markups, *volume));
  markups.markups.push_back({MarkupKind::distance, {in, out}});
  ASSERT_TRUE(outsideNote(markups, *volume));
  EXPECT_THAT(*outsideNote(markups, *volume), HasSubstr("1 of 2 markups"));
}

}  // namespace
}  // namespace perilymph::ct
