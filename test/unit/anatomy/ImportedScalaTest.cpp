// SPDX-License-Identifier: BSD-3-Clause

// Imported surfaces: the published scala written and read again, the measured mean scala as
// published by others, and surfaces that are no scala tympani.

#include "perilymph/anatomy/ImportedScala.h"

#include <gmock/gmock.h>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iterator>
#include <random>
#include <vector>

#include "perilymph/anatomy/MeanScala.h"
#include "perilymph/test/TemporaryFolder.h"
#include "perilymph/test/Tolerance.h"

namespace perilymph::anatomy {
namespace {

/// A binary STL in millimeters as a surface in meters; triangles share no corners.
Surface readStl(const std::filesystem::path& file)
{
  std::ifstream stream(file, std::ios::binary);
  const std::string content{std::istreambuf_iterator<char>(stream), {}};
  Surface surface;
  for (std::size_t at = 84; at + 50 <= content.size(); at += 50) {
    float corners[9];
    std::memcpy(corners, content.data() + at + 12, sizeof corners);
    const int first = static_cast<int>(surface.points.size());
    for (std::size_t k = 0; k < 3; ++k)
      surface.points.push_back({1e-3 * static_cast<double>(corners[3 * k]),
                                1e-3 * static_cast<double>(corners[3 * k + 1]),
                                1e-3 * static_cast<double>(corners[3 * k + 2])});
    surface.triangles.push_back({first, first + 1, first + 2});
  }
  return surface;
}

Surface writtenAndRead(const Surface& surface)
{
  const test::TemporaryFolder folder;
  EXPECT_TRUE(writeSurface(surface, "a test", folder / "a.stl"));
  return readStl(folder / "a.stl");
}

/// Rotated and translated as in a scan.
Surface moved(Surface surface, const Eigen::Matrix3d& turn, const Eigen::Vector3d& shift)
{
  for (auto& p : surface.points) {
    const Eigen::Vector3d q = turn * Eigen::Vector3d(p[0], p[1], p[2]) + shift;
    p = {q.x(), q.y(), q.z()};
  }
  return surface;
}

const Eigen::Matrix3d scanTurn = (Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, -1).normalized()) *
                                  Eigen::AngleAxisd(2.1, Eigen::Vector3d::UnitY()))
                                     .toRotationMatrix();
const Eigen::Vector3d scanShift(0.031, -0.112, 0.054);

class PublishedImport : public testing::Test {
protected:
  static void SetUpTestSuite()
  {
    scala = buildPublished({}, millimeters(1));
    const Surface scan = moved(writtenAndRead(wallSurface(*scala, 20'000)), scanTurn, scanShift);
    auto read = importScala(scan);
    ASSERT_TRUE(read) << read.error().message;
    imported = std::make_unique<ImportedScala>(*read);
    lumen = lumenOf(*imported);
  }
  static void TearDownTestSuite()
  {
    lumen.reset();
    imported.reset();
    scala.reset();
  }
  /// A point of the published scala's frame W in the frame of the import.
  static Eigen::Vector3d again(const Eigen::Vector3d& point_W)
  {
    return imported->place.into_W(scanTurn * point_W + scanShift);
  }

  static inline std::shared_ptr<const ScalaTympani> scala;
  static inline std::unique_ptr<ImportedScala> imported;
  static inline std::shared_ptr<const Lumen> lumen;
};

TEST_F(PublishedImport, FindsTheAxisItWasBuiltAbout)
{
  // the axis of the published scala is its z axis
  const Eigen::Vector3d along = again(Eigen::Vector3d::UnitZ()) - again(Eigen::Vector3d::Zero());
  const double tilt_deg =
      inDegrees(radians(std::atan2(std::hypot(along.x(), along.y()), along.z())));
  EXPECT_LT(tilt_deg, 1.0);
  for (const double z : {0.0, 1.28e-3, 2.56e-3}) {
    const Eigen::Vector3d p = again({0.0, 0.0, z});
    EXPECT_LT(std::hypot(p.x(), p.y()), 0.05e-3) << z;
  }
  EXPECT_EQ(imported->side, Side::right);
  RecordProperty("tilt_deg", std::to_string(tilt_deg));
}

TEST_F(PublishedImport, GivesItsMeasuresBack)
{
  // from the tables, by the definitions of A, B and H
  const auto outer = [](double angle_deg) {
    return scala->section(degrees(angle_deg).si()).outerRadius;
  };
  double floor = 1.0, roof = -1.0;
  for (double angle = 0.0; angle <= scala->lastAngle().si(); angle += 0.01) {
    floor = std::min(floor, scala->section(angle).floorHeight);
    roof = std::max(roof, scala->section(angle).roofHeight);
  }
  EXPECT_NEAR(inMillimeters(imported->a), 1e3 * (outer(0) + outer(180)), 0.03);
  EXPECT_NEAR(inMillimeters(imported->b), 1e3 * (outer(90) + outer(270)), 0.03);
  EXPECT_NEAR(inMillimeters(imported->h), 1e3 * (roof - floor), 0.03);
  // At the apex, 0.8 mm from the axis, an axis error of 0.04 mm is three degrees.
  EXPECT_NEAR(inDegrees(imported->lastAngle), inDegrees(scala->lastAngle()), 3.0);
  EXPECT_NEAR(inMillimeters(imported->leadIn), 1.0, 0.01);
}

TEST_F(PublishedImport, FindsTheOpening)
{
  const Entry entry = scala->entry();
  EXPECT_LT((imported->entry.origin_W - again(entry.origin_W)).norm(), 0.05e-3);
  EXPECT_GT(imported->entry.out_W.dot(again(entry.origin_W + entry.out_W) - again(entry.origin_W)),
            std::cos(degrees(1).si()));
}

TEST_F(PublishedImport, KeepsDistancesToTheWall)
{
  std::mt19937 random(11);
  std::uniform_real_distribution<double> angles(degrees(5).si(), degrees(960).si());
  std::uniform_real_distribution<double> directions(0.0, 2.0 * pi);
  std::uniform_real_distribution<double> fractions(0.0, 1.0);
  std::vector<double> errors;
  for (int i = 0; i < 500; ++i) {
    const double angle = angles(random);
    const Eigen::Vector3d center = scala->center_W(angle);
    const Eigen::Vector3d point =
        center + fractions(random) * (scala->wall_W(angle, directions(random)) - center);
    const double reach = 1.0;
    WallPoint here, there;
    const auto askTurn = [&](double turnsAngle) {
      LumenTrack track{false, turnsAngle, {std::cos(turnsAngle), std::sin(turnsAngle)}};
      WallPoint wall;
      scala->nearestWall({&point, 1}, {&reach, 1}, {&track, 1}, {&wall, 1});
      return wall;
    };
    here = askTurn(angle);
    // Turns of the published scala overlap. Its tables separate them, a surface does not: points
    // that are nearer to the wall of another turn are skipped.
    bool isAlone = true;
    for (const double other : {angle - 2.0 * pi, angle + 2.0 * pi})
      if (other > 0.0 && other < scala->lastAngle().si() + 0.6 &&
          -askTurn(other).distance < here.distance + 0.1e-3)
        isAlone = false;
    if (!isAlone) continue;
    const Eigen::Vector3d same = again(point);
    LumenTrack other{false, angle, {std::cos(angle), std::sin(angle)}};
    lumen->nearestWall({&same, 1}, {&reach, 1}, {&other, 1}, {&there, 1});
    ASSERT_TRUE(here.isNear && there.isNear) << i;
    errors.push_back(std::fabs(there.distance - here.distance));
    const double r = std::hypot(point.x(), point.y());
    EXPECT_NEAR(other.angle * r, angle * r, 0.06e-3) << "by the axis found";
  }
  std::sort(errors.begin(), errors.end());
  ASSERT_GT(errors.size(), 200u);
  EXPECT_LT(errors[errors.size() / 2], test::tolerance(0.005e-3, "both tables' smoothing"));
  EXPECT_LT(errors[errors.size() * 99 / 100], test::tolerance(0.05e-3, "a step of the grid"));
  // On a ridge the tables of the published scala deviate by up to 0.04 mm, and the grid adds its
  // own error.
  EXPECT_LT(errors.back(), test::tolerance(0.06e-3, "two rounded ridges"));
}

TEST_F(PublishedImport, GivesGradientAndTurningOfItsDistance)
{
  const auto ask = [&](const Eigen::Vector3d& p) {
    const double reach = 1.0;
    LumenTrack track{false, 3.0, {std::cos(3.0), std::sin(3.0)}};
    WallPoint wall;
    lumen->nearestWall({&p, 1}, {&reach, 1}, {&track, 1}, {&wall, 1});
    return wall;
  };
  std::mt19937 random(5);
  std::uniform_real_distribution<double> angles(0.5, 14.0), directions(0.0, 2.0 * pi);
  constexpr double nudge = 1e-7;
  for (int i = 0; i < 100; ++i) {
    const double angle = angles(random);
    const Eigen::Vector3d center = scala->center_W(angle);
    const Eigen::Vector3d p =
        again(center + 0.8 * (scala->wall_W(angle, directions(random)) - center));
    const WallPoint wall = ask(p);
    Eigen::Matrix3d bend;
    for (int axis = 0; axis < 3; ++axis) {
      const Eigen::Vector3d step = nudge * Eigen::Vector3d::Unit(axis);
      const WallPoint ahead = ask(p + step), behind = ask(p - step);
      EXPECT_NEAR(wall.normal_W[axis], (ahead.distance - behind.distance) / (2 * nudge), 1e-4);
      bend.col(axis) = (ahead.normal_W - behind.normal_W) / (2 * nudge);
    }
    // The shape operator plus the second derivative is a remainder on directions that the shape
    // operator maps to zero; the shape operator is positive semidefinite.
    const Eigen::Matrix3d rest = wall.shapeOperator_W + 0.5 * (bend + bend.transpose());
    EXPECT_LT((wall.shapeOperator_W * rest).norm(), 1e-4 * (1.0 + bend.squaredNorm()));
    EXPECT_GT(Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(wall.shapeOperator_W).eigenvalues()[0],
              -1e-6 * (1.0 + bend.norm()));
  }
}

TEST_F(PublishedImport, SeesNoWallBeforeTheOpening)
{
  const Entry entry = lumen->entry();
  const double reach = 0.3e-3;
  LumenTrack track = lumen->startTrack();
  WallPoint wall;
  const Eigen::Vector3d before = entry.origin_W + 0.2e-3 * entry.out_W;
  lumen->nearestWall({&before, 1}, {&reach, 1}, {&track, 1}, {&wall, 1});
  EXPECT_FALSE(wall.isNear);
  // The lid of the opening is no wall, even just inside its middle.
  const Eigen::Vector3d behind = entry.origin_W - 0.02e-3 * entry.out_W;
  lumen->nearestWall({&behind, 1}, {&reach, 1}, {&track, 1}, {&wall, 1});
  EXPECT_FALSE(wall.isNear);
  EXPECT_TRUE(track.inLeadIn);
  const Eigen::Vector3d nowhere(std::nan(""), 0.0, 0.0);
  lumen->nearestWall({&nowhere, 1}, {&reach, 1}, {&track, 1}, {&wall, 1});
  EXPECT_FALSE(wall.isNear);
}

TEST_F(PublishedImport, TellsALeftEarAndMirrorsIt)
{
  Surface left = wallSurface(*scala, 20'000);
  for (auto& p : left.points) p[1] = -p[1];
  const auto read = importScala(moved(left, scanTurn, scanShift));
  ASSERT_TRUE(read) << read.error().message;
  EXPECT_EQ(read->side, Side::left);
  EXPECT_NEAR(inMillimeters(read->a), inMillimeters(imported->a), 1e-3);
  EXPECT_NEAR(inMillimeters(read->h), inMillimeters(imported->h), 1e-3);
  EXPECT_NEAR(inDegrees(read->lastAngle), inDegrees(imported->lastAngle), 0.2);
  EXPECT_LT(read->place.axes_IW.determinant(), 0.0);
  EXPECT_LT((read->entry.origin_W - imported->entry.origin_W).norm(), 1e-6);
}

TEST(ImportedScala, MeasuresTheMeanScalaAsItsAuthorsFrameHasIt)
{
  const char* const folder = std::getenv("PERILYMPH_REFERENCE_DATA");
  if (folder == nullptr)
    GTEST_SKIP() << "PERILYMPH_REFERENCE_DATA does not name the folder of the reference data";
  const auto file = std::filesystem::path(folder) / "st_mean_2024" / "st_mean_model_mm.stl";
  if (!std::filesystem::exists(file)) GTEST_SKIP() << file << " is not there";
  const auto read = importScala(readStl(file));
  ASSERT_TRUE(read) << read.error().message;
  // 9.53 and 6.82 mm, 675 degrees and 33.4 mm3 about the z axis of the authors' frame
  EXPECT_NEAR(inMillimeters(read->a), 9.53, 0.10);
  EXPECT_NEAR(inMillimeters(read->b), 6.82, 0.10);
  // At the apex, 0.73 mm from the axis, an axis error of 0.1 mm is eight degrees.
  EXPECT_NEAR(inDegrees(read->lastAngle), 675.0, 8.0);
  EXPECT_NEAR(1e9 * read->volume, 33.4, 0.2);
  EXPECT_EQ(read->side, Side::right);
  const Eigen::Vector3d axis = read->place.axes_IW.col(2);
  EXPECT_GT(axis.z(), std::cos(degrees(6).si()));
  const Eigen::Vector3d off =
      read->place.origin_I - Eigen::Vector3d(-2.6909e-3, 3.8483e-3, read->place.origin_I.z());
  EXPECT_LT(off.norm(), 0.25e-3);
}

TEST(ImportedScala, FollowsADuctWhoseApexReachesTheAxis)
{
  // The shipped mean scala ends at 900 degrees, where its inner wall is 0.1 mm from the axis.
  const auto mean = buildMean(millimeters(1));
  ASSERT_TRUE(mean) << mean.error().message;
  const auto read = importScala(wallSurface(**mean, 20'000));
  ASSERT_TRUE(read) << read.error().message;
  EXPECT_NEAR(inDegrees(read->lastAngle), inDegrees((*mean)->lastAngle()), 10.0);
  EXPECT_NEAR(inMillimeters(read->a), 9.53, 0.1);
  EXPECT_NEAR(inMillimeters(read->b), 6.82, 0.1);
}

// --- surfaces that are no scala tympani ---

void expectRefusal(const Surface& surface, const std::string& says)
{
  const auto read = importScala(surface);
  ASSERT_FALSE(read);
  EXPECT_THAT(read.error().message, testing::HasSubstr(says));
}

Surface published() { return wallSurface(*buildPublished({}, millimeters(1)), 8000); }

TEST(ImportedScala, RefusesAnotherUnit)
{
  Surface inMeters = published();
  for (auto& p : inMeters.points)
    for (double& x : p) x *= 1e-3;
  expectRefusal(inMeters, "millimeters");
}

TEST(ImportedScala, RefusesTwoPieces)
{
  Surface two = published();
  const Surface other = moved(published(), Eigen::Matrix3d::Identity(), {0.012, 0.0, 0.0});
  const int first = static_cast<int>(two.points.size());
  two.points.insert(two.points.end(), other.points.begin(), other.points.end());
  for (auto t : other.triangles) {
    for (int& k : t) k += first;
    two.triangles.push_back(t);
  }
  for (auto& p : two.points)
    for (double& x : p) x *= 0.6;  // both together as long as one
  expectRefusal(two, "2 separate pieces");
}

TEST(ImportedScala, RefusesASecondOpening)
{
  Surface open = published();
  // the last point is the center of the fan that closes the apex
  const int apex = static_cast<int>(open.points.size()) - 1;
  std::erase_if(open.triangles,
                [&](const auto& t) { return std::find(t.begin(), t.end(), apex) != t.end(); });
  expectRefusal(open, "more than one opening");
}

TEST(ImportedScala, ClosesASmallHole)
{
  Surface holed = wallSurface(*buildPublished({}, millimeters(1)), 20'000);
  holed.triangles.erase(holed.triangles.begin() + 9000);
  const auto read = importScala(holed);
  ASSERT_TRUE(read) << read.error().message;
  EXPECT_NEAR(inMillimeters(read->a), 9.54, 0.05);
}

TEST(ImportedScala, RefusesABall)
{
  // closed, in one piece, of plausible size and volume, but no spiral
  Surface ball;
  constexpr int rings = 30, around = 60;
  const double radii[3] = {3.5e-3, 1.5e-3, 1.8e-3};
  for (int i = 1; i < rings; ++i)
    for (int k = 0; k < around; ++k) {
      const double polar = pi * i / rings, turn = 2.0 * pi * k / around;
      ball.points.push_back({radii[0] * std::sin(polar) * std::cos(turn),
                             radii[1] * std::sin(polar) * std::sin(turn),
                             radii[2] * std::cos(polar)});
    }
  const int top = static_cast<int>(ball.points.size());
  ball.points.push_back({0.0, 0.0, radii[2]});
  ball.points.push_back({0.0, 0.0, -radii[2]});
  for (int k = 0; k < around; ++k) {
    const int next = (k + 1) % around;
    ball.triangles.push_back({top, k, next});
    for (int i = 0; i + 2 < rings; ++i) {
      const int a = i * around + k, b = i * around + next;
      ball.triangles.push_back({a, a + around, b});
      ball.triangles.push_back({b, a + around, b + around});
    }
    const int last = (rings - 2) * around;
    ball.triangles.push_back({top + 1, last + next, last + k});
  }
  expectRefusal(ball, "Keep the scala tympani alone");
}

TEST(ImportedScala, RefusesNumbersAndNamesThatAreNone)
{
  Surface broken = published();
  broken.points[17][1] = std::nan("");
  expectRefusal(broken, "finite");
  broken = published();
  broken.triangles[5][2] = 1'000'000;
  expectRefusal(broken, "names the corner 1000000");
  expectRefusal(Surface{}, "0 triangles");
}

}  // namespace
}  // namespace perilymph::anatomy
