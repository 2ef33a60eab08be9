// SPDX-License-Identifier: BSD-3-Clause

// Surfaces with a crack: refused with its place, or measured as without it.

#include <gmock/gmock.h>

#include <Eigen/Geometry>
#include <cmath>
#include <cstdio>
#include <random>

#include "importing/ClosedSurface.h"
#include "perilymph/anatomy/ImportedScala.h"
#include "perilymph/anatomy/MeanScala.h"

namespace perilymph::anatomy {
namespace {

using testing::HasSubstr;

/// Triangles that share no corner, as STL keeps them.
Surface soupOf(const Surface& surface)
{
  Surface soup;
  for (const auto& t : surface.triangles) {
    const int first = static_cast<int>(soup.points.size());
    for (const int index : t)
      soup.points.push_back(surface.points[static_cast<std::size_t>(index)]);
    soup.triangles.push_back({first, first + 1, first + 2});
  }
  return soup;
}

Surface open(int triangles) { return wallSurface(**buildMean(millimeters(1)), triangles); }

/// The same with a lid over its opening, as most segmentation programs write it.
Surface closed(int triangles) { return importScala(open(triangles))->closed_W; }

Eigen::Vector3d randomDirection(std::mt19937& random)
{
  std::normal_distribution<double> normal;
  return Eigen::Vector3d(normal(random), normal(random), normal(random)).normalized();
}

/// A corner of one triangle moved: the place where it was [m].
Eigen::Vector3d tear(Surface& soup, double distance, std::mt19937& random)
{
  auto& point = soup.points[random() % soup.points.size()];
  const Eigen::Vector3d before(point[0], point[1], point[2]);
  const Eigen::Vector3d after = before + distance * randomDirection(random);
  point = {after.x(), after.y(), after.z()};
  return before;
}

/// The place in millimeters that a refusal states.
Eigen::Vector3d statedPlace(const std::string& message)
{
  Eigen::Vector3d place = Eigen::Vector3d::Constant(1e9);
  const std::size_t at = message.find("at (");
  if (at != std::string::npos)
    std::sscanf(message.c_str() + at, "at (%lf, %lf, %lf) mm", &place[0], &place[1], &place[2]);
  return place;
}

TEST(ATornSurface, IsRefusedWithThePlaceOfTheTear)
{
  std::mt19937 random(7);
  for (const Surface& whole : {open(20'000), closed(50'000)})
    for (const double distance_mm : {0.6, 1.0, 2.0, 3.0, 4.0, 5.0})
      for (int repeat = 0; repeat < 3; ++repeat) {
        Surface soup = soupOf(whole);
        const Eigen::Vector3d place = tear(soup, 1e-3 * distance_mm, random);
        const auto read = closeSurface(soup);
        ASSERT_FALSE(read) << distance_mm;
        EXPECT_THAT(read.error().message, HasSubstr("torn at ("));
        EXPECT_LT((statedPlace(read.error().message) - 1e3 * place).norm(), distance_mm + 0.5)
            << read.error().message;
      }
}

TEST(ATornSurface, OfLargeTrianglesIsRefusedOrMeasuredAsWithoutTheTear)
{
  std::mt19937 random(8);
  for (const Surface& whole : {open(2000), closed(2000)}) {
    const auto exact = importScala(whole);
    ASSERT_TRUE(exact) << exact.error().message;
    int refused = 0;
    for (const double distance_mm : {0.1, 0.3, 0.5, 0.7, 1.0, 1.5, 2.0, 3.0, 5.0}) {
      Surface soup = soupOf(whole);
      tear(soup, 1e-3 * distance_mm, random);
      const auto read = importScala(soup);
      if (!read) {
        ++refused;
        EXPECT_THAT(read.error().message,
                    testing::AnyOf(HasSubstr("torn at ("), HasSubstr("mm at (")))
            << distance_mm;
        continue;
      }
      EXPECT_LT(distance_mm, 1.5);
      EXPECT_NEAR(inMillimeters(read->a), inMillimeters(exact->a), 0.05) << distance_mm;
      EXPECT_NEAR(inMillimeters(read->b), inMillimeters(exact->b), 0.05) << distance_mm;
      EXPECT_NEAR(inMillimeters(read->h), inMillimeters(exact->h), 0.05) << distance_mm;
    }
    EXPECT_GE(refused, 4);
  }
}

TEST(ATornSurface, IsReadWhereTheCrackIsSmall)
{
  std::mt19937 random(9);
  for (const Surface& whole : {open(20'000), closed(50'000)})
    for (const double distance_mm : {0.0005, 0.01, 0.1, 0.3})
      for (int repeat = 0; repeat < 2; ++repeat) {
        Surface soup = soupOf(whole);
        tear(soup, 1e-3 * distance_mm, random);
        const auto read = closeSurface(soup);
        EXPECT_TRUE(read) << distance_mm << ": " << read.error().message;
      }
  Surface soup = soupOf(closed(20'000));
  const auto exact = importScala(soup);
  tear(soup, 0.3e-3, random);
  const auto read = importScala(soup);
  ASSERT_TRUE(read) << read.error().message;
  EXPECT_NEAR(inMillimeters(read->a), inMillimeters(exact->a), 0.02);
}

TEST(ATornSurface, IsNoneWhereACornerOfAllItsTrianglesWasMoved)
{
  std::mt19937 random(10);
  const Surface whole = closed(20'000);
  for (const double distance_mm : {1.0, 3.0, 5.0})
    for (int repeat = 0; repeat < 4; ++repeat) {
      Surface spiked = whole;
      tear(spiked, 1e-3 * distance_mm, random);
      const auto read = closeSurface(soupOf(spiked));
      EXPECT_TRUE(read) << distance_mm << ": " << read.error().message;
    }
}

TEST(ASurfaceWithAHoleInItsSide, IsRefusedWithThePlaceOfTheHole)
{
  // all triangles within a radius of a corner of the wall are missing
  std::mt19937 random(11);
  const Surface whole = closed(20'000);
  const auto exact = importScala(whole);
  int refused = 0;
  for (const double radius_mm : {0.4, 0.6})
    for (int repeat = 0; repeat < 4; ++repeat) {
      Surface holed = whole;
      const auto& c = whole.points[random() % whole.points.size()];
      const Eigen::Vector3d center(c[0], c[1], c[2]);
      std::erase_if(holed.triangles, [&](const std::array<int, 3>& t) {
        for (const int index : t) {
          const auto& p = holed.points[static_cast<std::size_t>(index)];
          if ((Eigen::Vector3d(p[0], p[1], p[2]) - center).norm() < 1e-3 * radius_mm) return true;
        }
        return false;
      });
      const auto read = importScala(holed);
      if (!read) {
        ++refused;
        EXPECT_LT((statedPlace(read.error().message) - 1e3 * center).norm(), radius_mm + 0.5)
            << read.error().message;
        continue;
      }
      // a rim of less than 2 mm, as of a hole of the segmentation, is closed
      EXPECT_NEAR(inMillimeters(read->a), inMillimeters(exact->a), 0.05) << radius_mm;
      EXPECT_NEAR(inMillimeters(read->b), inMillimeters(exact->b), 0.05) << radius_mm;
    }
  EXPECT_GE(refused, 5);
}

}  // namespace
}  // namespace perilymph::anatomy
