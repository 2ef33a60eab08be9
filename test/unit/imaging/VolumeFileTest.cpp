// SPDX-License-Identifier: BSD-3-Clause

// NIfTI and NRRD files written by the test, with both byte orders and every kind of matrix.

#include <gmock/gmock.h>
#include <zlib.h>

#include <bit>
#include <cstring>
#include <fstream>

#include "SmallCt.h"
#include "perilymph/imaging/CtSeries.h"
#include "perilymph/test/TemporaryFolder.h"

namespace perilymph::imaging {
namespace {

using testing::HasSubstr;

/// Bytes of a value in one of the two orders.
class Bytes {
public:
  explicit Bytes(std::size_t size, bool isBigEndian = false)
      : content(size, '\0'), isBig(isBigEndian)
  {
  }

  template <class Value>
  void put(std::size_t at, Value value)
  {
    char bytes[sizeof value];
    std::memcpy(bytes, &value, sizeof value);  // this machine's order, little-endian
    for (std::size_t k = 0; k < sizeof value; ++k)
      content[at + k] = bytes[isBig ? sizeof value - 1 - k : k];
  }

  std::string content;
  bool isBig;
};

Eigen::Matrix3d obliqueAxes()
{
  return Eigen::AngleAxisd(0.4, Eigen::Vector3d(0.3, -0.8, 0.5).normalized()).toRotationMatrix();
}

/// A CT with an oblique matrix.
ct::CtVolume obliqueCt() { return smallCt(obliqueAxes(), {0.3, 0.4, 0.6}); }

template <class Value>
void putVoxels(Bytes& bytes, std::size_t from, const ct::CtVolume& volume, double slope = 1.0,
               double intercept = 0.0)
{
  std::size_t at = from;
  for (int k = 0; k < volume.size()[2]; ++k)
    for (int j = 0; j < volume.size()[1]; ++j)
      for (int i = 0; i < volume.size()[0]; ++i, at += sizeof(Value))
        bytes.put(at, static_cast<Value>((volume.voxel(i, j, k) - intercept) / slope));
}

enum class Form { sform, qform, none };

constexpr std::size_t firstVoxel = 352, voxelCount = 12 * 10 * 8;

/// A NIfTI-1 file of 16-bit voxels, or of voxels that the caller gives.
Bytes nifti(const ct::CtVolume& volume, Form form, bool isBigEndian = false)
{
  Bytes bytes(firstVoxel + 2 * voxelCount, isBigEndian);
  bytes.put<std::int32_t>(0, 348);
  bytes.put<std::int16_t>(40, 3);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    bytes.put<std::int16_t>(42 + 2 * axis, static_cast<std::int16_t>(volume.size()[axis]));
    bytes.put<float>(80 + 4 * axis,
                     static_cast<float>(volume.spacing_mm()[static_cast<Eigen::Index>(axis)]));
  }
  bytes.put<std::int16_t>(70, 4);
  bytes.put<std::int16_t>(72, 16);
  bytes.put<float>(76, 1.0F);
  bytes.put<float>(108, firstVoxel);
  bytes.content[123] = 2;
  std::memcpy(bytes.content.data() + 344, "n+1", 4);
  Eigen::Matrix4d ras = volume.lpsFromIndex();
  ras.topRows<2>() *= -1.0;
  if (form == Form::sform) {
    bytes.put<std::int16_t>(254, 1);
    for (std::size_t row = 0; row < 3; ++row)
      for (std::size_t column = 0; column < 4; ++column)
        bytes.put<float>(280 + 16 * row + 4 * column,
                         static_cast<float>(ras(static_cast<Eigen::Index>(row),
                                                static_cast<Eigen::Index>(column))));
  }
  if (form == Form::qform) {
    Eigen::Matrix3d axes = ras.topLeftCorner<3, 3>();
    for (Eigen::Index axis = 0; axis < 3; ++axis) axes.col(axis).normalize();
    if (axes.determinant() < 0.0) {
      axes.col(2) = -axes.col(2);
      bytes.put<float>(76, -1.0F);
    }
    Eigen::Quaterniond turn(axes);
    if (turn.w() < 0.0) turn.coeffs() = -turn.coeffs();
    bytes.put<std::int16_t>(252, 1);
    const Eigen::Vector3d vector = turn.vec();
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto a = static_cast<Eigen::Index>(axis);
      bytes.put<float>(256 + 4 * axis, static_cast<float>(vector[a]));
      bytes.put<float>(268 + 4 * axis, static_cast<float>(ras(a, 3)));
    }
  }
  putVoxels<std::int16_t>(bytes, firstVoxel, volume);
  return bytes;
}

std::string nrrdHeader(const std::string& type, const std::string& encoding,
                       const std::string& space, double sign)
{
  const Eigen::Matrix4d lps = obliqueCt().lpsFromIndex();
  const auto vector = [&](Eigen::Index column) {
    return "(" + std::to_string(sign * lps(0, column)) + "," +
           std::to_string(sign * lps(1, column)) + "," + std::to_string(lps(2, column)) + ")";
  };
  return "NRRD0004\n# made by hand\ntype: " + type + "\ndimension: 3\nspace: " + space +
         "\nsizes: 12 10 8\nspace directions: " + vector(0) + " " + vector(1) + " " + vector(2) +
         "\nkinds: domain domain domain\nendian: little\n" + "encoding: " + encoding +
         "\nspace origin: " + vector(3) + "\nkey:=value\n\n";
}

std::string gzipped(const std::string& content)
{
  z_stream stream = {};
  deflateInit2(&stream, 6, Z_DEFLATED, 15 + 16, 8, Z_DEFAULT_STRATEGY);
  std::string packed(content.size() + 1000, '\0');
  std::string given = content;
  stream.next_in = reinterpret_cast<unsigned char*>(given.data());
  stream.avail_in = static_cast<unsigned>(given.size());
  stream.next_out = reinterpret_cast<unsigned char*>(packed.data());
  stream.avail_out = static_cast<unsigned>(packed.size());
  deflate(&stream, Z_FINISH);
  packed.resize(stream.total_out);
  deflateEnd(&stream);
  return packed;
}

class VolumeFiles : public testing::Test {
protected:
  Result<LoadedCt> read(const std::string& name, const std::string& content)
  {
    std::ofstream(folder / name, std::ios::binary) << content;
    return readCt(folder / name);
  }

  void expectSame(const ct::CtVolume& expected, const Result<LoadedCt>& loaded)
  {
    ASSERT_TRUE(loaded) << loaded.error().message;
    const ct::CtVolume& found = loaded->volume;
    ASSERT_EQ(found.size(), expected.size());
    EXPECT_LT((found.lpsFromIndex() - expected.lpsFromIndex()).cwiseAbs().maxCoeff(), 1e-4);
    for (int k = 0; k < 8; ++k)
      for (int j = 0; j < 10; ++j)
        for (int i = 0; i < 12; ++i) ASSERT_EQ(found.voxel(i, j, k), expected.voxel(i, j, k));
  }

  void expectRefusal(const Result<LoadedCt>& loaded, const std::string& says)
  {
    ASSERT_FALSE(loaded) << says;
    EXPECT_THAT(loaded.error().message, HasSubstr(says));
    EXPECT_THAT(loaded.error().message, testing::EndsWith("."));
  }

  test::TemporaryFolder folder;
};

TEST_F(VolumeFiles, OfNiftiLieWhereTheSFormSaysInBothByteOrders)
{
  for (const bool isBigEndian : {false, true})
    expectSame(obliqueCt(), read("a.nii", nifti(obliqueCt(), Form::sform, isBigEndian).content));
}

TEST_F(VolumeFiles, OfNiftiLieWhereTheQFormSaysWithoutAnSForm)
{
  expectSame(obliqueCt(), read("a.nii", nifti(obliqueCt(), Form::qform).content));
  Eigen::Matrix3d mirrored = obliqueAxes();
  mirrored.col(2) = -mirrored.col(2);
  const ct::CtVolume leftHanded = smallCt(mirrored, {0.3, 0.4, 0.6});
  expectSame(leftHanded, read("b.nii", nifti(leftHanded, Form::qform).content));
}

TEST_F(VolumeFiles, OfNiftiWithoutAFormAreRefused)
{
  expectRefusal(read("a.nii", nifti(obliqueCt(), Form::none).content),
                "neither an SForm nor a QForm");
}

TEST_F(VolumeFiles, AreReadGzippedAsTheyAreReadPlain)
{
  expectSame(obliqueCt(), read("a.nii.gz", gzipped(nifti(obliqueCt(), Form::sform).content)));
}

TEST_F(VolumeFiles, AreScaledBySlopeAndIntercept)
{
  Bytes bytes = nifti(obliqueCt(), Form::sform);
  bytes.put<float>(112, 0.5F);
  bytes.put<float>(116, -1024.0F);
  putVoxels<std::uint16_t>(bytes, firstVoxel, obliqueCt(), 0.5, -1024.0);
  bytes.put<std::int16_t>(70, 512);
  expectSame(obliqueCt(), read("a.nii", bytes.content));
}

TEST_F(VolumeFiles, MayHoldFloatingNumbers)
{
  Bytes bytes = nifti(obliqueCt(), Form::sform);
  bytes.content.resize(firstVoxel + 4 * voxelCount);
  putVoxels<float>(bytes, firstVoxel, obliqueCt());
  bytes.put<std::int16_t>(70, 16);
  bytes.put<std::int16_t>(72, 32);
  expectSame(obliqueCt(), read("a.nii", bytes.content));
  bytes.content.resize(firstVoxel + 8 * voxelCount);
  putVoxels<double>(bytes, firstVoxel, obliqueCt());
  bytes.put<std::int16_t>(70, 64);
  bytes.put<std::int16_t>(72, 64);
  expectSame(obliqueCt(), read("b.nii", bytes.content));
  bytes.put<double>(firstVoxel, std::numeric_limits<double>::quiet_NaN());
  expectRefusal(read("c.nii", bytes.content), "not finite");
}

TEST_F(VolumeFiles, OfNrrdLieWhereTheirSpaceSays)
{
  Bytes voxels(2 * voxelCount);
  putVoxels<std::int16_t>(voxels, 0, obliqueCt());
  for (const auto& [space, sign] :
       std::vector<std::pair<std::string, double>>{{"left-posterior-superior", 1.0},
                                                   {"LPS", 1.0},
                                                   {"right-anterior-superior", -1.0},
                                                   {"RAS", -1.0}}) {
    expectSame(obliqueCt(),
               read("a.nrrd", nrrdHeader("short", "raw", space, sign) + voxels.content));
    expectSame(obliqueCt(),
               read("b.nrrd", nrrdHeader("int16", "gzip", space, sign) + gzipped(voxels.content)));
  }
}

TEST_F(VolumeFiles, OfNrrdWithoutAPlaceInThePatientAreRefused)
{
  Bytes voxels(2 * voxelCount);
  putVoxels<std::int16_t>(voxels, 0, obliqueCt());
  const std::string header = nrrdHeader("short", "raw", "LPS", 1.0);
  const auto without = [&](const std::string& field) {
    std::string cut = header;
    const std::size_t at = cut.find("\n" + field + ":") + 1;
    cut.erase(at, cut.find('\n', at) + 1 - at);
    return cut + voxels.content;
  };
  for (const char* field : {"space", "space directions", "space origin"})
    expectRefusal(read("a.nrrd", without(field)), "no space, directions and origin");
  expectRefusal(read("a.nrrd", without("sizes")), "no volume of three dimensions");
  expectRefusal(read("a.nrrd", without("endian")), "the order of its bytes");
  expectRefusal(read("a.nrrd", nrrdHeader("short", "bzip2", "LPS", 1.0) + voxels.content),
                "is encoded as 'bzip2'");
  expectRefusal(read("a.nrrd", nrrdHeader("short", "raw", "scanner-xyz", 1.0) + voxels.content),
                "no space, directions and origin");
}

TEST_F(VolumeFiles, ThatAreCutOffAreRefused)
{
  const std::string plain = nifti(obliqueCt(), Form::sform).content;
  ASSERT_TRUE(read("whole.nii", plain));
  const std::string packed = gzipped(plain);
  for (std::size_t bytes = 0; bytes < plain.size(); bytes += 41)
    EXPECT_FALSE(read("cut.nii", plain.substr(0, bytes))) << bytes;
  for (std::size_t bytes = 0; bytes < packed.size(); bytes += 41)
    EXPECT_FALSE(read("cut.nii.gz", packed.substr(0, bytes))) << bytes;
  expectRefusal(read("cut.nii", plain.substr(0, plain.size() - 1)), "cut off or damaged");
  const std::string header = nrrdHeader("short", "gzip", "LPS", 1.0);
  expectRefusal(read("cut.nrrd", header), "cut off or damaged");
  expectRefusal(read("cut.nrrd", header.substr(0, 100)), "no NRRD file with a whole header");
}

TEST_F(VolumeFiles, ThatAreNoCtOrTooLargeAreRefused)
{
  Bytes mask = nifti(obliqueCt(), Form::sform);
  for (std::size_t i = 0; i < voxelCount; ++i)
    mask.put<std::int16_t>(firstVoxel + 2 * i, static_cast<std::int16_t>(i % 3));
  expectRefusal(read("mask.nii", mask.content), "span less than 100");

  Bytes huge = nifti(obliqueCt(), Form::sform);
  for (std::size_t axis = 0; axis < 3; ++axis) huge.put<std::int16_t>(42 + 2 * axis, 2000);
  expectRefusal(read("huge.nii", huge.content), "8000 million voxels");

  Bytes series = nifti(obliqueCt(), Form::sform);
  series.put<std::int16_t>(40, 4);
  series.put<std::int16_t>(48, 3);
  expectRefusal(read("series.nii", series.content), "more than one volume");

  Bytes colors = nifti(obliqueCt(), Form::sform);
  colors.put<std::int16_t>(70, 128);
  expectRefusal(read("colors.nii", colors.content), "no gray values");
}

TEST_F(VolumeFiles, AreListedAsOneSeries)
{
  std::ofstream(folder / "a.nii", std::ios::binary) << nifti(obliqueCt(), Form::sform).content;
  const auto list = findSeries(folder / "a.nii");
  ASSERT_TRUE(list) << list.error().message;
  ASSERT_EQ(list->series.size(), 1u);
  EXPECT_EQ(list->series.front().format, "NIfTI");
  EXPECT_NEAR(list->series.front().spacing_mm.z(), 0.6, 1e-5);
  const auto loaded = readCt(folder / "a.nii");
  ASSERT_TRUE(loaded);
  EXPECT_EQ(loaded->volume.provenance().seriesKey.size(), 64u);
}

}  // namespace
}  // namespace perilymph::imaging
