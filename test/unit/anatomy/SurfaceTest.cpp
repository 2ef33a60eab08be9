// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/anatomy/Surface.h"

#include <gmock/gmock.h>

#include <Eigen/Geometry>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <map>

#include "perilymph/anatomy/MeanScala.h"
#include "perilymph/anatomy/Patient.h"
#include "perilymph/foundation/AtomicFile.h"
#include "perilymph/test/TemporaryFolder.h"

namespace perilymph::anatomy {
namespace {

std::shared_ptr<const ScalaTympani> published() { return buildPublished({}, millimeters(1)); }

Eigen::Vector3d point(const Surface& surface, int index)
{
  const auto& p = surface.points[static_cast<std::size_t>(index)];
  return {p[0], p[1], p[2]};
}

TEST(WallSurface, KeepsToItsNumberOfTriangles)
{
  const auto scala = published();
  for (const int maximum : {200, 1000, 20000}) {
    const auto count = static_cast<int>(wallSurface(*scala, maximum).triangles.size());
    EXPECT_LE(count, maximum);
    EXPECT_GT(count, maximum * 7 / 10);
  }
}

TEST(WallSurface, IsClosedButForItsOpening)
{
  const Surface surface = wallSurface(*published(), 5000);
  std::map<std::pair<int, int>, int> edges;
  for (const auto& t : surface.triangles)
    for (std::size_t k = 0; k < 3; ++k) edges[{t[k], t[(k + 1) % 3]}]++;
  int open = 0;
  for (const auto& [edge, count] : edges) {
    ASSERT_EQ(count, 1);  // each edge once in each direction: consistent orientation
    if (edges.find({edge.second, edge.first}) == edges.end()) ++open;
  }
  EXPECT_EQ(open, static_cast<int>(std::sqrt(5000 / 12.0)));  // the rim: one edge per direction
}

TEST(WallSurface, FacesOutward)
{
  const auto scala = published();
  const Surface surface = wallSurface(*scala, 4000);
  // By the divergence theorem the enclosed volume (the rim closed by a fan) is positive if the
  // surface faces outward. It is that of the mean scala, whose sections are used: 33.4 mm3.
  double volume = 0.0;
  const Eigen::Vector3d apex = scala->entry().origin_W;
  for (const auto& t : surface.triangles)
    volume += (point(surface, t[0]) - apex)
                  .dot((point(surface, t[1]) - apex).cross(point(surface, t[2]) - apex)) /
              6.0;
  EXPECT_GT(volume, 25e-9);
  EXPECT_LT(volume, 45e-9);
}

TEST(WriteSurface, WritesBinaryStlInMillimeters)
{
  const test::TemporaryFolder folder;
  const Surface surface = wallSurface(*published(), 400);
  const auto file = folder.path() / "scala.stl";
  ASSERT_TRUE(writeSurface(surface, "published scala tympani", file));
  const auto content = readWhole(file);
  ASSERT_TRUE(content);
  ASSERT_EQ(content->size(), 84 + 50 * surface.triangles.size());
  std::uint32_t count = 0;
  std::memcpy(&count, content->data() + 80, 4);
  EXPECT_EQ(count, surface.triangles.size());
  float x = 0;
  std::memcpy(&x, content->data() + 84 + 12, 4);
  EXPECT_NEAR(x, 1e3 * point(surface, surface.triangles[0][0]).x(), 1e-5);
}

TEST(MembraneSurface, LiesBetweenTheWallsUpToTheApex)
{
  constexpr double rounding =
      2e-6;  // [m], of a section's bounds, which are taken at some directions
  const auto mean = buildMean(millimeters(1));
  ASSERT_TRUE(mean);
  for (const auto& scala : {published(), *mean}) {
    constexpr int rings = 101;
    const Surface ribbon = membraneSurface(*scala, 2 * (rings - 1));
    ASSERT_EQ(ribbon.points.size(), 2u * rings);
    for (std::size_t i = 0; i < ribbon.points.size(); ++i) {
      const double angle = scala->lastAngle().si() * double(i / 2) / (rings - 1);
      const Section bounds = scala->section(angle);
      const auto& [x, y, z] = ribbon.points[i];
      const double radius = x * std::cos(angle) + y * std::sin(angle);
      EXPECT_GE(radius, bounds.innerRadius - rounding) << angle;
      EXPECT_LE(radius, bounds.outerRadius + rounding) << angle;
      EXPECT_LE(z, bounds.roofHeight + rounding) << angle;
      EXPECT_GE(z, bounds.floorHeight - rounding) << angle;
    }
  }
}

TEST(WriteSurface, NamesTheEndingsItKnows)
{
  const test::TemporaryFolder folder;
  const Surface surface = membraneSurface(*published(), 200);
  for (const char* name : {"a.ply", "a.obj", "a.wrl", "a.vtp"})
    EXPECT_TRUE(writeSurface(surface, "membrane", folder.path() / name)) << name;
  const auto refused = writeSurface(surface, "membrane", folder.path() / "a.docx");
  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.error().message, testing::HasSubstr(".stl, .ply, .obj, .wrl or .vtp"));
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "a.docx"));
}

}  // namespace
}  // namespace perilymph::anatomy
