// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/imaging/DecimatedSurface.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>

#include "perilymph/anatomy/Patient.h"
#include "perilymph/anatomy/SurfaceDistance.h"

namespace perilymph::imaging {
namespace {

constexpr int visual = 20'000;

class PublishedHapticSurface : public testing::Test {
protected:
  static void SetUpTestSuite()
  {
    scala = anatomy::buildPublished({}, millimeters(1));
    auto made = hapticSurface(*scala, visual);
    ASSERT_TRUE(made) << made.error().message;
    haptic = std::make_unique<HapticSurface>(*made);
  }
  static void TearDownTestSuite()
  {
    haptic.reset();
    scala.reset();
  }

  static inline std::shared_ptr<const anatomy::ScalaTympani> scala;
  static inline std::unique_ptr<HapticSurface> haptic;
};

TEST_F(PublishedHapticSurface, HasNinetyFivePercentFewerTriangles)
{
  const double fraction = static_cast<double>(haptic->surface.triangles.size()) /
                          static_cast<double>(haptic->visualTriangles);
  EXPECT_LE(fraction, 0.0502);
  EXPECT_GT(fraction, 0.045);
}

TEST_F(PublishedHapticSurface, EndsAtTwoTurnsAndAtTheOpening)
{
  // the rim: edges of only one triangle
  std::map<std::pair<int, int>, int> edges;
  for (const auto& t : haptic->surface.triangles)
    for (std::size_t k = 0; k < 3; ++k)
      edges[{std::min(t[k], t[(k + 1) % 3]), std::max(t[k], t[(k + 1) % 3])}]++;
  int atOpening = 0, atTwoTurns = 0;
  const Eigen::Vector3d twoTurns = scala->center_W(degrees(717).si());
  for (const auto& [edge, count] : edges) {
    if (count == 2) continue;
    const auto& p = haptic->surface.points[static_cast<std::size_t>(edge.first)];
    const Eigen::Vector3d place(p[0], p[1], p[2]);
    if ((place - scala->entry().origin_W).norm() < 1.4e-3) {
      ++atOpening;
      continue;
    }
    ++atTwoTurns;
    // two turns end in the half-plane of the x axis; rings are about 7 degrees apart there
    EXPECT_LT((place - twoTurns).norm(), 1.0e-3);
    EXPECT_GT(std::atan2(place.y(), place.x()), degrees(-9).si());
    EXPECT_LT(std::atan2(place.y(), place.x()), degrees(1).si());
  }
  EXPECT_GT(atOpening, 3);
  EXPECT_GT(atTwoTurns, 3);

  // the wall before two turns is complete
  const anatomy::SurfaceDistance distance(haptic->surface);
  for (double angle_deg = 20; angle_deg < 710; angle_deg += 30)
    EXPECT_LT(distance.nearest(scala->wall_W(degrees(angle_deg).si(), 1.0)).distance, 0.1e-3)
        << angle_deg;
}

TEST_F(PublishedHapticSurface, StaysNearTheVisualSurface)
{
  // An independent check in one direction: points of the wall from the tables.
  const anatomy::SurfaceDistance distance(haptic->surface);
  double sum = 0.0, greatest = 0.0;
  int count = 0;
  for (double angle_deg = 1; angle_deg < 715; angle_deg += 3.7)
    for (double direction = 0; direction < 6.28; direction += 0.31) {
      const double off =
          distance.nearest(scala->wall_W(degrees(angle_deg).si(), direction)).distance;
      sum += off;
      greatest = std::max(greatest, off);
      ++count;
    }
  EXPECT_NEAR(sum / count, haptic->surfaceDistance.mean.si(), 0.004e-3);
  EXPECT_LT(greatest, haptic->surfaceDistance.greatest.si() + 0.01e-3);
  // a tenth of the thinnest array tip, 0.5 mm: a coarser surface could be felt
  EXPECT_LT(haptic->surfaceDistance.p95.si(), 0.05e-3);
  EXPECT_LE(haptic->surfaceDistance.mean, haptic->surfaceDistance.p95);
  EXPECT_LE(haptic->surfaceDistance.p95, haptic->surfaceDistance.greatest);
}

TEST_F(PublishedHapticSurface, FacesAsTheVisualOneDoes)
{
  const auto& surface = haptic->surface;
  const auto at = [&](int i) {
    const auto& p = surface.points[static_cast<std::size_t>(i)];
    return Eigen::Vector3d(p[0], p[1], p[2]);
  };
  // Each edge occurs at most once in each direction: consistent orientation, no folds.
  std::map<std::pair<int, int>, int> edges;
  int outward = 0;
  for (const auto& t : surface.triangles) {
    for (std::size_t k = 0; k < 3; ++k) EXPECT_EQ(++(edges[{t[k], t[(k + 1) % 3]}]), 1);
    // in the basal turn's outer half away from the axis is outward
    const Eigen::Vector3d normal = (at(t[1]) - at(t[0])).cross(at(t[2]) - at(t[0]));
    const Eigen::Vector3d middle = (at(t[0]) + at(t[1]) + at(t[2])) / 3.0;
    if (std::hypot(middle.x(), middle.y()) < 5.5e-3) continue;
    outward += normal.x() * middle.x() + normal.y() * middle.y() > 0.0 ? 1 : -1;
  }
  EXPECT_GT(outward, 0);
}

}  // namespace
}  // namespace perilymph::imaging
