// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/imaging/SurfaceReader.h"

#include <gmock/gmock.h>

#include <bit>
#include <cstdint>
#include <fstream>

#include "perilymph/test/TemporaryFolder.h"

namespace perilymph::imaging {
namespace {

class ReadSurface : public testing::Test {
protected:
  Result<anatomy::Surface> read(const std::string& name, const std::string& content)
  {
    std::ofstream(folder / name, std::ios::binary) << content;
    return readSurface(folder / name);
  }
  test::TemporaryFolder folder;
};

const std::string square =
    "ply\nformat ascii 1.0\ncomment a square\nelement vertex 4\nproperty float x\n"
    "property float y\nproperty float z\nproperty uchar red\nelement face 1\n"
    "property list uchar int vertex_indices\nend_header\n"
    "0 0 1 255\n2 0 1 255\n2 3 1 0\n0 3 1 7\n4 0 1 2 3\n";

TEST_F(ReadSurface, MakesTrianglesOfAPolygonInMillimeters)
{
  const auto surface = read("a.ply", square);
  ASSERT_TRUE(surface) << surface.error().message;
  ASSERT_EQ(surface->points.size(), 4u);
  EXPECT_THAT(surface->points[2], testing::ElementsAre(0.002, 0.003, 0.001));
  EXPECT_THAT(surface->triangles,
              testing::ElementsAre(testing::ElementsAre(0, 1, 2), testing::ElementsAre(0, 2, 3)));
}

TEST_F(ReadSurface, ReadsBinaryOfBothByteOrders)
{
  for (const bool isLittle : {true, false}) {
    std::string content =
        std::string("ply\nformat binary_") + (isLittle ? "little" : "big") +
        "_endian 1.0\nelement vertex 3\nproperty float x\nproperty double y\n"
        "property short z\nelement face 1\nproperty list uchar uint vertex_index\n"
        "end_header\n";
    const auto put = [&](std::uint64_t bits, int bytes) {
      for (int k = 0; k < bytes; ++k)
        content += static_cast<char>(bits >> (8 * (isLittle ? k : bytes - 1 - k)) & 0xff);
    };
    for (int i = 0; i < 3; ++i) {
      put(std::bit_cast<std::uint32_t>(static_cast<float>(i)), 4);
      put(std::bit_cast<std::uint64_t>(i * i * 1.0), 8);
      put(static_cast<std::uint16_t>(-i), 2);
    }
    put(3, 1);
    for (const unsigned corner : {2u, 1u, 0u}) put(corner, 4);
    const auto surface = read("b.ply", content);
    ASSERT_TRUE(surface) << surface.error().message;
    EXPECT_THAT(surface->points[2], testing::ElementsAre(0.002, 0.004, -0.002));
    EXPECT_THAT(surface->triangles, testing::ElementsAre(testing::ElementsAre(2, 1, 0)));
  }
}

TEST_F(ReadSurface, RefusesEveryPlyThatWasCutOff)
{
  // Without the last digit of the last corner the file is incomplete; the newline may be missing.
  for (std::size_t bytes = 0; bytes + 1 < square.size(); ++bytes) {
    const auto surface = read("cut.ply", square.substr(0, bytes));
    ASSERT_FALSE(surface) << bytes;
    EXPECT_THAT(surface.error().message, testing::HasSubstr("not a whole .ply"));
  }
}

TEST_F(ReadSurface, RefusesCornersThatAreNotThere)
{
  for (const char* corners : {"4 0 1 2 4", "4 0 1 2 -1", "4 0 1 2 1.5", "4 0 1 2 nan"}) {
    std::string content = square;
    content.replace(content.find("4 0 1 2 3"), 9, corners);
    EXPECT_FALSE(read("d.ply", content)) << corners;
  }
}

TEST_F(ReadSurface, RefusesAnStlThatBeginsWithWordsAndGoesOnWithACount)
{
  // A byte above ASCII makes VTK read it as binary: 1000 triangles, of which one exists.
  std::string content = "solid facet \xff";
  content.resize(80, ' ');
  content += std::string("\xe8\x03\0\0", 4) + std::string(50, '\0');
  const auto surface = read("words.stl", content);
  ASSERT_FALSE(surface);
  EXPECT_THAT(surface.error().message, testing::HasSubstr("not a whole .stl file"));
}

TEST_F(ReadSurface, RefusesAnStlOfControlCharacters)
{
  // Only ASCII, but VTK reads it as binary, with 303 million triangles.
  const std::string content = "solid facet " + std::string(72, '\x12') + std::string(50, ' ');
  const auto surface = read("control.stl", content);
  ASSERT_FALSE(surface);
  EXPECT_THAT(surface.error().message, testing::HasSubstr("not a whole .stl file"));
}

TEST_F(ReadSurface, NamesTheEndingsItReads)
{
  const auto surface = read("a.obj", "v 0 0 0\n");
  ASSERT_FALSE(surface);
  EXPECT_THAT(surface.error().message, testing::HasSubstr(".stl, .ply or .vtp"));
}

}  // namespace
}  // namespace perilymph::imaging
