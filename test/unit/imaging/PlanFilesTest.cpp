// SPDX-License-Identifier: BSD-3-Clause

// Markups and glTF of a plan, read back as other programs read them.

#include "perilymph/imaging/PlanFiles.h"

#include <gmock/gmock.h>

#include <cstring>
#include <nlohmann/json.hpp>

#include "perilymph/foundation/AtomicFile.h"
#include "perilymph/test/TemporaryFolder.h"

namespace perilymph::imaging {
namespace {

using Eigen::Vector3d;
using Json = nlohmann::json;

TEST(PlanMarkups, HaveAListForEachPartThatIsThere)
{
  PlanMarkups plan;
  plan.marks[ct::Mark::roundWindow] = Vector3d(1, 2, 3);
  plan.axis = {Vector3d(0, 0, 0), Vector3d(0, 0, 4)};
  plan.array = {Vector3d(0, 0, 0), Vector3d(1, 0, 0), Vector3d(2, 0, 0)};
  plan.contacts = {Vector3d(1.5, 0, 0)};
  const Json markups = Json::parse(planText(plan)).at("markups");
  ASSERT_EQ(markups.size(), 4u);
  EXPECT_EQ(markups[0].at("name"), "landmarks");
  EXPECT_EQ(markups[1].at("type"), "Line");
  EXPECT_EQ(markups[1].at("controlPoints").size(), 2u);
  EXPECT_EQ(markups[2].at("type"), "Curve");
  EXPECT_EQ(markups[3].at("controlPoints")[0].at("label"), "E1");
  EXPECT_EQ(markups[3].at("controlPoints")[0].at("position"), (Json{1.5, 0.0, 0.0}));
  for (const Json& markup : markups) EXPECT_EQ(markup.at("coordinateSystem"), "LPS");
}

std::string fromBase64(const std::string& text)
{
  std::string bytes;
  unsigned collected = 0;
  int bits = 0;
  for (const char c : text) {
    if (c == '=') break;
    const int digit = c >= 'A' && c <= 'Z'   ? c - 'A'
                      : c >= 'a' && c <= 'z' ? c - 'a' + 26
                      : c >= '0' && c <= '9' ? c - '0' + 52
                      : c == '+'             ? 62
                                             : 63;
    collected = collected << 6 | static_cast<unsigned>(digit);
    bits += 6;
    if (bits < 8) continue;
    bits -= 8;
    bytes += static_cast<char>(collected >> bits & 0xFFu);
  }
  return bytes;
}

TEST(Gltf, HoldsThePointsInMillimetersAndTheTriangles)
{
  const anatomy::Surface surface{{{0, 0, 0}, {1e-3, 0, 0}, {0, 2e-3, 0}, {0, 0, -3e-3}},
                                 {{0, 1, 2}, {0, 2, 3}}};
  const test::TemporaryFolder folder;
  ASSERT_TRUE(writeGltf(surface, "a tetrahedron's sides", folder / "s.gltf"));
  const auto content = readWhole(folder / "s.gltf");
  ASSERT_TRUE(content);
  const Json gltf = Json::parse(*content);
  EXPECT_EQ(gltf.at("asset").at("version"), "2.0");
  EXPECT_EQ(gltf.at("scenes")[0].at("nodes")[0], 0);
  const Json& primitive = gltf.at("meshes")[0].at("primitives")[0];
  const Json& points = gltf.at("accessors")[primitive.at("attributes").at("POSITION").get<int>()];
  const Json& corners = gltf.at("accessors")[primitive.at("indices").get<int>()];
  EXPECT_EQ(points.at("count"), 4);
  EXPECT_EQ(points.at("min")[2], -3.0);
  EXPECT_EQ(points.at("max")[1], 2.0);
  EXPECT_EQ(corners.at("count"), 6);
  const std::string uri = gltf.at("buffers")[0].at("uri");
  const std::string bytes = fromBase64(uri.substr(uri.find(',') + 1));
  ASSERT_EQ(bytes.size(), gltf.at("buffers")[0].at("byteLength").get<std::size_t>());
  ASSERT_EQ(bytes.size(), 4u * 12 + 6 * 4);
  float y = 0.0F;
  std::memcpy(&y, bytes.data() + 2 * 12 + 4, sizeof y);
  EXPECT_EQ(y, 2.0F);
  std::uint32_t last = 0;
  std::memcpy(&last, bytes.data() + 4 * 12 + 5 * 4, sizeof last);
  EXPECT_EQ(last, 3u);
}

}  // namespace
}  // namespace perilymph::imaging
