// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/imaging/SurfaceReader.h"

#include <gmock/gmock.h>
#include <sys/resource.h>
#include <zlib.h>

#include <array>
#include <bit>
#include <cmath>
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
  // two triangles by either diagonal, both turned as the polygon
  ASSERT_EQ(surface->triangles.size(), 2u);
  for (const auto& t : surface->triangles) {
    const auto at = [&](int k) {
      return surface->points[static_cast<std::size_t>(t[static_cast<std::size_t>(k)])];
    };
    EXPECT_NEAR((at(1)[0] - at(0)[0]) * (at(2)[1] - at(0)[1]) -
                    (at(1)[1] - at(0)[1]) * (at(2)[0] - at(0)[0]),
                0.002 * 0.003, 1e-12);
  }
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
    EXPECT_THAT(surface.error().message,
                testing::AnyOf(testing::HasSubstr("not a whole .ply"),
                               testing::HasSubstr("the points and faces that its header states")));
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

TEST_F(ReadSurface, RefusesEveryBinaryPlyThatIsShorterOrLongerThanItsCounts)
{
  std::string content =
      "ply\nformat binary_little_endian 1.0\nelement vertex 4\nproperty float x\nproperty float y\n"
      "property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n";
  const std::size_t header = content.size();
  for (int i = 0; i < 4; ++i)
    for (const float x : {static_cast<float>(i), static_cast<float>(i * i), 1.0F})
      content.append(reinterpret_cast<const char*>(&x), sizeof x);
  content += '\4';
  for (const std::int32_t corner : {0, 1, 2, 3})
    content.append(reinterpret_cast<const char*>(&corner), sizeof corner);
  ASSERT_TRUE(read("whole.ply", content));
  for (std::size_t bytes = header; bytes < content.size(); bytes += 7)
    EXPECT_FALSE(read("cut.ply", content.substr(0, bytes))) << bytes;
  EXPECT_FALSE(read("longer.ply", content + "more"));
  // without x; and points of more than five million
  std::string other = content;
  EXPECT_THAT(read("a.ply", other.replace(other.find(" x\n"), 3, " u\n")).error().message,
              testing::HasSubstr("has no points with x, y and z"));
  other = content;
  EXPECT_THAT(
      read("a.ply", other.replace(other.find("vertex 4"), 8, "vertex 5000001")).error().message,
      testing::HasSubstr("at most 5 million"));
  other = content;
  EXPECT_THAT(
      read("a.ply", other.replace(other.find("vertex_ind"), 10, "somethings")).error().message,
      testing::HasSubstr("no faces with a list of their corners"));
}

TEST_F(ReadSurface, RefusesAFaceOfMoreCornersThanAByteCounts)
{
  // VTK would take 300 corners for 44
  for (const bool isText : {true, false}) {
    std::string content = std::string("ply\nformat ") +
                          (isText ? "ascii" : "binary_little_endian") +
                          " 1.0\nelement vertex 300\nproperty float x\nproperty float y\n"
                          "property float z\nelement face 1\nproperty list int int vertex_indices\n"
                          "end_header\n";
    const auto put = [&](auto value) {
      if (isText)
        content += std::to_string(value) + " ";
      else
        content.append(reinterpret_cast<const char*>(&value), sizeof value);
    };
    for (int i = 0; i < 300; ++i) {
      put(std::cos(0.02F * static_cast<float>(i)));
      put(std::sin(0.02F * static_cast<float>(i)));
      put(0.0F);
      if (isText) content += "\n";
    }
    put(300);
    for (int i = 0; i < 300; ++i) put(i);
    if (isText) content += "\n";
    EXPECT_FALSE(read("many.ply", content)) << isText;
  }
}

/// A tetrahedron in text.
std::string textStl(const std::string& name, const std::string& corner = "1 2.5 -0.25")
{
  std::string content = "solid " + name + "\n";
  const std::string corners[] = {"0 0 0", corner, "0 1 0", "0 0 1"};
  for (const auto& face : {std::array{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}) {
    content += "  facet normal 0 0 0\n    outer loop\n";
    for (const int k : face)
      content += "      vertex " + corners[static_cast<std::size_t>(k)] + "\n";
    content += "    endloop\n  endfacet\n";
  }
  return content + "endsolid " + name + "\n";
}

TEST_F(ReadSurface, ReadsAnStlInTextByItsBodyWhateverItsName)
{
  const auto plain = read("plain.stl", textStl("plain"));
  ASSERT_TRUE(plain) << plain.error().message;
  EXPECT_EQ(plain->triangles.size(), 4u);
  for (const char* name : {"H\xc3\xb6rschnecke", "h\xf6r", "scala, links 1,5", "", "facet",
                           "\xe8\x9d\xb8\xe7\x89\x9b", "a\tb", "solid solid"}) {
    const auto surface = read("name.stl", textStl(name));
    ASSERT_TRUE(surface) << name << ": " << surface.error().message;
    EXPECT_EQ(surface->points, plain->points) << name;
    EXPECT_EQ(surface->triangles, plain->triangles) << name;
  }
}

TEST_F(ReadSurface, NamesNumbersWithADecimalComma)
{
  const auto stl = read("comma.stl", textStl("scala", "1,25 2,5 -0,25"));
  ASSERT_FALSE(stl);
  EXPECT_THAT(stl.error().message,
              testing::HasSubstr("numbers with a decimal comma, such as '1,25'"));
  std::string content = square;
  content.replace(content.find("2 3 1 0"), 7, "2,5 3 1 0");
  const auto ply = read("comma.ply", content);
  ASSERT_FALSE(ply);
  EXPECT_THAT(ply.error().message,
              testing::HasSubstr("numbers with a decimal comma, such as '2,5'"));
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

std::string base64(const std::string& bytes)
{
  constexpr const char* digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t three = 0;
    for (std::size_t k = 0; k < 3; ++k)
      three = three << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0);
    for (std::size_t k = 0; k < 4; ++k)
      text += i + k > bytes.size() ? '=' : digits[three >> (18 - 6 * k) & 63];
  }
  return text;
}

/// A VTP of one triangle whose points are compressed blocks of zeros, each of `blockBytes`.
std::string compressedVtp(std::uint64_t blocks, std::uint64_t blockBytes, const char* type)
{
  const std::string zeros(blockBytes, '\0');
  uLongf size = compressBound(blockBytes);
  std::string block(size, '\0');
  compress2(reinterpret_cast<Bytef*>(block.data()), &size,
            reinterpret_cast<const Bytef*>(zeros.data()), blockBytes, 9);
  block.resize(size);
  std::string header, data;
  const auto put = [&header](std::uint64_t value) {
    for (int k = 0; k < 8; ++k) header += static_cast<char>(value >> (8 * k) & 0xff);
  };
  put(blocks);
  put(blockBytes);
  put(0);
  for (std::uint64_t i = 0; i < blocks; ++i) {
    put(size);
    data += block;
  }
  const std::string points = std::to_string(blocks * blockBytes / 24);
  return "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"1.0\" "
         "byte_order=\"LittleEndian\" header_type=\"UInt64\" compressor=\"vtkZLibDataCompressor\">"
         "<PolyData><Piece NumberOfPoints=\"" +
         points +
         "\" NumberOfVerts=\"0\" NumberOfLines=\"0\" NumberOfStrips=\"0\" NumberOfPolys=\"1\">"
         "<Points><DataArray type=\"" +
         type + "\" NumberOfComponents=\"3\" format=\"binary\">" + base64(header) + base64(data) +
         "</DataArray></Points><Polys>"
         "<DataArray type=\"Int64\" Name=\"connectivity\" format=\"ascii\">0 1 2</DataArray>"
         "<DataArray type=\"Int64\" Name=\"offsets\" format=\"ascii\">3</DataArray>"
         "</Polys></Piece></PolyData></VTKFile>\n";
}

TEST_F(ReadSurface, ReadsACompressedVtp)
{
  const auto surface = read("whole.vtp", compressedVtp(1, 72, "Float64"));
  ASSERT_TRUE(surface) << surface.error().message;
  EXPECT_EQ(surface->points.size(), 3u);
  EXPECT_EQ(surface->triangles.size(), 1u);
}

#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
// A sanitizer's own memory hides what the program takes.
TEST_F(ReadSurface, TakesNoMoreThanOneGigabyteForASmallFileThatUnpacksToMore)
{
  // 3 MB that unpack to 2.4 GB, the points of an array of as many again.
  const auto surface = read("bomb.vtp", compressedVtp(75, 32'000'016, "Float64"));
  ASSERT_FALSE(surface);
  EXPECT_THAT(surface.error().message, testing::HasSubstr("needs over 1 GiB"));
  rusage used{};
  ASSERT_EQ(::getrusage(RUSAGE_CHILDREN, &used), 0);
  EXPECT_LT(used.ru_maxrss, 1'500'000);  // [kB]
}
#endif

TEST_F(ReadSurface, KeepsWhatVtkPrintsAwayFromTheTerminal)
{
  testing::internal::CaptureStderr();
  testing::internal::CaptureStdout();
  const auto surface = read("type.vtp", compressedVtp(1, 72, "Float99"));
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
  ASSERT_FALSE(surface);
  EXPECT_THAT(surface.error().message, testing::HasSubstr("not a whole .vtp file"));
}

}  // namespace
}  // namespace perilymph::imaging
