// SPDX-License-Identifier: BSD-3-Clause

// NIfTI, NRRD and MetaImage files written by the test, with both byte orders and every kind of matrix.

#include <gmock/gmock.h>

#include <cmath>
#include <fstream>
#include <limits>
#include <numbers>

#include "SmallVolumeFiles.h"
#include "perilymph/imaging/CtSeries.h"
#include "perilymph/test/TemporaryFolder.h"

namespace perilymph::imaging {
namespace {

using testing::HasSubstr;

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
    expectSame(obliqueCt(),
               read("a.nii", niftiFile(obliqueCt(), Form::sform, isBigEndian).content));
}

TEST_F(VolumeFiles, OfNiftiLieWhereTheQFormSaysWithoutAnSForm)
{
  expectSame(obliqueCt(), read("a.nii", niftiFile(obliqueCt(), Form::qform).content));
  Eigen::Matrix3d mirrored = obliqueAxes();
  mirrored.col(2) = -mirrored.col(2);
  const ct::CtVolume leftHanded = smallCt(mirrored, {0.3, 0.4, 0.6});
  expectSame(leftHanded, read("b.nii", niftiFile(leftHanded, Form::qform).content));
}

TEST_F(VolumeFiles, OfNiftiWithoutAFormAreRefused)
{
  expectRefusal(read("a.nii", niftiFile(obliqueCt(), Form::none).content),
                "neither an SForm nor a QForm");
}

TEST_F(VolumeFiles, AreReadGzippedAsTheyAreReadPlain)
{
  expectSame(obliqueCt(), read("a.nii.gz", gzipped(niftiFile(obliqueCt(), Form::sform).content)));
}

TEST_F(VolumeFiles, AreScaledBySlopeAndIntercept)
{
  Bytes bytes = niftiFile(obliqueCt(), Form::sform);
  bytes.put<float>(112, 0.5F);
  bytes.put<float>(116, -1024.0F);
  putVoxels<std::uint16_t>(bytes, firstVoxel, obliqueCt(), 0.5, -1024.0);
  bytes.put<std::int16_t>(70, 512);
  expectSame(obliqueCt(), read("a.nii", bytes.content));
}

TEST_F(VolumeFiles, MayHoldFloatingNumbers)
{
  Bytes bytes = niftiFile(obliqueCt(), Form::sform);
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

TEST_F(VolumeFiles, FarFromThePatientAreRefused)
{
  for (const float far_mm : {2e6F, -1e9F, 1e30F})
    for (const std::size_t axis : {0U, 1U, 2U}) {
      Bytes bytes = niftiFile(obliqueCt(), Form::sform);
      bytes.put<float>(292 + 16 * axis, far_mm);
      expectRefusal(read("far.nii", bytes.content), "more than 1 km from the origin");
    }
}

TEST_F(VolumeFiles, OfNiftiThatStateLabelsOrStatisticsAreRefused)
{
  for (const int intent : {2, 5, 1002, 1007, 2003, -1}) {
    Bytes bytes = niftiFile(obliqueCt(), Form::sform);
    bytes.put<std::int16_t>(68, static_cast<std::int16_t>(intent));
    expectRefusal(read("labels.nii", bytes.content), "intent_code " + std::to_string(intent));
  }
}

TEST_F(VolumeFiles, ThatAreCutOffAreRefused)
{
  const std::string plain = niftiFile(obliqueCt(), Form::sform).content;
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
  Bytes mask = niftiFile(obliqueCt(), Form::sform);
  for (std::size_t i = 0; i < voxelCount; ++i)
    mask.put<std::int16_t>(firstVoxel + 2 * i, static_cast<std::int16_t>(i % 3));
  expectRefusal(read("mask.nii", mask.content), "span less than 100");

  Bytes huge = niftiFile(obliqueCt(), Form::sform);
  for (std::size_t axis = 0; axis < 3; ++axis) huge.put<std::int16_t>(42 + 2 * axis, 2000);
  expectRefusal(read("huge.nii", huge.content), "8000 million voxels");

  Bytes series = niftiFile(obliqueCt(), Form::sform);
  series.put<std::int16_t>(40, 4);
  series.put<std::int16_t>(48, 3);
  expectRefusal(read("series.nii", series.content), "more than one volume");

  Bytes colors = niftiFile(obliqueCt(), Form::sform);
  colors.put<std::int16_t>(70, 128);
  expectRefusal(read("colors.nii", colors.content), "no gray values");
}

TEST_F(VolumeFiles, AreListedAsOneSeries)
{
  std::ofstream(folder / "a.nii", std::ios::binary) << niftiFile(obliqueCt(), Form::sform).content;
  const auto list = findSeries(folder / "a.nii");
  ASSERT_TRUE(list) << list.error().message;
  ASSERT_EQ(list->series.size(), 1u);
  EXPECT_EQ(list->series.front().format, "NIfTI");
  EXPECT_NEAR(list->series.front().spacing_mm.z(), 0.6, 1e-5);
  const auto loaded = readCt(folder / "a.nii");
  ASSERT_TRUE(loaded);
  EXPECT_EQ(loaded->volume.provenance().seriesKey.size(), 64u);
}

TEST_F(VolumeFiles, OfMetaImageLieWhereTheirMatrixSays)
{
  const std::string voxels = obliqueVoxels();
  expectSame(obliqueCt(), read("a.mha", metaHeader() + voxels));
  expectSame(obliqueCt(), read("b.mha", metaHeader("CompressedData = True\n") + zipped(voxels)));
  expectSame(obliqueCt(), read("c.mha", metaHeader("CompressedData = True\nCompressedDataSize = " +
                                                   std::to_string(zipped(voxels).size()) + "\n") +
                                            zipped(voxels)));
  // older names, and another unit
  std::string old = replaced(metaHeader(), "TransformMatrix", "Rotation");
  old = replaced(replaced(old, "Offset", "Position"), "0.3 0.4 0.6", "300 400 600");
  const std::size_t at = old.find("Position = ") + 11;
  old.replace(at, old.find('\n', at) - at, "-31250 12500 -400750");
  expectSame(obliqueCt(),
             read("d.mha", replaced(old, "DimSize", "DistanceUnits = um\nDimSize") + voxels));
  std::ofstream(folder / "voxels.raw", std::ios::binary) << voxels;
  expectSame(obliqueCt(), read("e.mhd", metaHeader("", "voxels.raw")));
}

TEST_F(VolumeFiles, OfMetaImageThatAreNoCtOfThreeDimensionsInTheirFolderAreRefused)
{
  const std::string voxels = obliqueVoxels();
  expectRefusal(read("a.mha", replaced(metaHeader(), "Offset", "Nowhere") + voxels),
                "no TransformMatrix, Offset and ElementSpacing");
  expectRefusal(read("a.mha", metaHeader("Modality = MET_MOD_MR\n") + voxels),
                "of the modality MET_MOD_MR");
  expectRefusal(read("a.mha", metaHeader("ElementNumberOfChannels = 3\n") + voxels),
                "no gray values");
  expectRefusal(read("a.mha", metaHeader("ElementToIntensityFunctionSlope = 2\n") + voxels),
                "ElementToIntensityFunction");
  for (const char* place : {"/etc/passwd", "../voxels.raw", "LIST", "slice%03d.raw", ".."})
    expectRefusal(read("a.mhd", metaHeader("", place)), "in the header's folder");
  expectRefusal(read("a.mhd", metaHeader("", "missing.raw")), "missing.raw cannot be read");
  expectRefusal(read("a.mha", metaHeader().substr(0, 200)),
                "no MetaImage file with a whole header");
}

TEST_F(VolumeFiles, OfNrrdMayKeepTheirVoxelsInAFileOfTheirFolder)
{
  std::ofstream(folder / "voxels.raw", std::ios::binary) << obliqueVoxels();
  std::ofstream(folder / "voxels.raw.gz", std::ios::binary) << gzipped(obliqueVoxels());
  std::ofstream(folder / "voxels.head", std::ios::binary) << "12 bytes----" + obliqueVoxels();
  const auto header = [](const std::string& encoding, const std::string& more) {
    std::string text = nrrdHeader("short", encoding, "LPS", 1.0);
    text.pop_back();
    return text + more;
  };
  expectSame(obliqueCt(), read("a.nhdr", header("raw", "data file: voxels.raw\n")));
  expectSame(obliqueCt(), read("b.nhdr", header("raw", "data file: ./voxels.raw")));
  expectSame(obliqueCt(), read("c.nhdr", header("gzip", "datafile: voxels.raw.gz\n\n")));
  expectSame(obliqueCt(), read("d.nhdr", header("raw", "byte skip: 12\ndata file: voxels.head\n")));
  for (const char* place : {"/etc/passwd", "../voxels.raw", "LIST", "slice%03d.raw 1 8 1"})
    expectRefusal(read("e.nhdr", header("raw", std::string("data file: ") + place + "\n")),
                  "in the header's folder");
}

TEST_F(VolumeFiles, AreReadByTheNameOfTheirFolder)
{
  std::ofstream(folder / "notes.txt") << "of the scan";
  std::ofstream(folder / "a.nii", std::ios::binary) << niftiFile(obliqueCt(), Form::both).content;
  expectSame(obliqueCt(), readCt(folder / ""));
  std::ofstream(folder / "b.mha", std::ios::binary) << metaHeader() + obliqueVoxels();
  expectRefusal(readCt(folder / ""), "holds 2 volumes, the first a.nii. Give one of these files");
  // beside files that may be DICOM, these are looked for
  std::ofstream(folder / "IM0001") << "none";
  expectRefusal(readCt(folder / ""), "holds no DICOM image");
}

TEST_F(VolumeFiles, AreReadInTheUnitThatTheyState)
{
  // micrometers: everything is a thousand times as much
  ct::CtVolume large = smallCt(obliqueAxes(), {300.0, 400.0, 600.0});
  Bytes bytes = niftiFile(large, Form::both);
  bytes.content[123] = 3;
  const auto micrometers = read("a.nii", bytes.content);
  ASSERT_TRUE(micrometers) << micrometers.error().message;
  EXPECT_NEAR(micrometers->volume.spacing_mm().y(), 0.4, 1e-6);
  EXPECT_NEAR(micrometers->volume.toLps(Eigen::Vector3d::Zero()).x(), -0.03125, 1e-7);
  bytes.content[123] = 2;
  expectRefusal(read("a.nii", bytes.content),
                "voxels of 300 mm along i where 0.01 to 10 mm are read; its unit of length is the "
                "millimeter (xyzt_units)");
  bytes.content[123] = 5;
  expectRefusal(read("a.nii", bytes.content), "by the code 5, which is none");

  const std::string header = nrrdHeader("short", "raw", "LPS", 1.0);
  const auto stating = [&](const std::string& unit) {
    return replaced(header, "\nsizes:",
                    "\nspace units: \"" + unit + "\" \"" + unit + "\" \"" + unit + "\"\nsizes:") +
           obliqueVoxels();
  };
  expectSame(obliqueCt(), read("a.nrrd", stating("mm")));
  const auto centimeters = read("a.nrrd", stating("cm"));
  ASSERT_TRUE(centimeters) << centimeters.error().message;
  EXPECT_NEAR(centimeters->volume.spacing_mm().y(), 4.0, 1e-4);
  expectRefusal(read("a.nrrd", stating("um")), "voxels of 0.0003 mm along i");
  expectRefusal(read("a.nrrd", stating("furlong")), "states its unit of length as");
}

TEST_F(VolumeFiles, WhoseAxesAreNotAtRightAnglesAreRefused)
{
  for (const double shear_deg : {0.1, 1.0, 8.5, 45.0}) {
    Eigen::Matrix3d axes = obliqueAxes();
    const double turn = shear_deg / 180.0 * std::numbers::pi;
    axes.col(1) = std::cos(turn) * axes.col(1) + std::sin(turn) * axes.col(0);
    const ct::CtVolume sheared = smallCt(axes, {0.3, 0.4, 0.6});
    const std::string says = "axes i and j that meet at";
    expectRefusal(read("a.nii", niftiFile(sheared, Form::sform).content), says);
    const auto vector = [&](Eigen::Index column) {
      const Eigen::Vector3d v = sheared.lpsFromIndex().block<3, 1>(0, column);
      return "(" + std::to_string(v.x()) + "," + std::to_string(v.y()) + "," +
             std::to_string(v.z()) + ")";
    };
    std::string header = nrrdHeader("short", "raw", "LPS", 1.0);
    const std::size_t at = header.find("directions: ") + 12;
    header.replace(at, header.find('\n', at) - at, vector(0) + " " + vector(1) + " " + vector(2));
    expectRefusal(read("a.nrrd", header + obliqueVoxels()), says);
  }
  Eigen::Matrix3d rounded = obliqueAxes();
  rounded.col(1) += 5e-4 * rounded.col(0);
  expectSame(smallCt(rounded, {0.3, 0.4, 0.6}),
             read("b.nii", niftiFile(smallCt(rounded, {0.3, 0.4, 0.6}), Form::sform).content));
}

TEST_F(VolumeFiles, OfNiftiUseTheQFormWhereTheSFormIsNone)
{
  for (const float value : {0.0F, std::numeric_limits<float>::quiet_NaN()}) {
    Bytes bytes = niftiFile(obliqueCt(), Form::both);
    for (std::size_t at = 280; at < 328; at += 4) bytes.put<float>(at, value);
    const auto loaded = read("a.nii", bytes.content);
    expectSame(obliqueCt(), loaded);
    EXPECT_THAT(loaded->series.warnings, testing::Contains(HasSubstr("the QForm is used")));
    Bytes alone = niftiFile(obliqueCt(), Form::sform);
    for (std::size_t at = 280; at < 328; at += 4) alone.put<float>(at, value);
    expectRefusal(read("b.nii", alone.content), "neither an SForm nor a QForm");
  }
}

TEST_F(VolumeFiles, OfNiftiUseTheScannersSpaceBesideATemplates)
{
  // an affine registration to a template: other sizes and another place
  Bytes bytes = niftiFile(obliqueCt(), Form::both);
  for (const std::int16_t code : {std::int16_t{3}, std::int16_t{4}}) {
    bytes.put<std::int16_t>(254, code);
    for (std::size_t at = 280; at < 328; at += 4) {
      Bytes original = niftiFile(obliqueCt(), Form::both);
      float value = 0.0F;
      std::memcpy(&value, original.content.data() + at, sizeof value);
      bytes.put<float>(at, 1.2F * value);
    }
    const auto loaded = read("a.nii", bytes.content);
    expectSame(obliqueCt(), loaded);
    EXPECT_THAT(loaded->series.warnings, testing::Contains(HasSubstr("check the sides")));
  }
}

TEST_F(VolumeFiles, OfNiftiScaledByNothingAreRefusedOrRead)
{
  for (const auto& [slope, intercept] : std::vector<std::pair<float, float>>{
           {NAN, 0.0F}, {1.0F, NAN}, {-1.0F, 0.0F}, {INFINITY, 0.0F}}) {
    Bytes bytes = niftiFile(obliqueCt(), Form::sform);
    bytes.put<float>(112, slope);
    bytes.put<float>(116, intercept);
    expectRefusal(read("a.nii", bytes.content), "scl_slope or scl_inter");
  }
}

}  // namespace
}  // namespace perilymph::imaging
