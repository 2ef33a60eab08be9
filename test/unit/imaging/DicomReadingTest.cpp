// SPDX-License-Identifier: BSD-3-Clause

// Series written by the test are read at their positions in the patient, within 1 um.

#include <gmock/gmock.h>

#include <cmath>
#include <fstream>
#include <system_error>

#include "SmallCt.h"
#include "perilymph/imaging/CtSeries.h"
#include "perilymph/test/ChildProcess.h"
#include "perilymph/test/DicomWriter.h"
#include "perilymph/test/TemporaryFolder.h"

namespace perilymph::imaging {
namespace {

constexpr double exact_mm = 1e-3;

/// Every voxel of one volume is in the other, at the same position and with the same value.
void expectSame(const ct::CtVolume& expected, const ct::CtVolume& found)
{
  ASSERT_EQ(found.size()[0], expected.size()[0]);
  ASSERT_EQ(found.size()[1], expected.size()[1]);
  ASSERT_EQ(found.size()[2], expected.size()[2]);
  for (int k = 0; k < expected.size()[2]; ++k)
    for (int j = 0; j < expected.size()[1]; ++j)
      for (int i = 0; i < expected.size()[0]; ++i) {
        const Eigen::Vector3d place_P = expected.toLps({1.0 * i, 1.0 * j, 1.0 * k});
        const Eigen::Vector3d index = found.toIndex(place_P);
        const Eigen::Vector3d nearest = index.array().round();
        ASSERT_LT((found.toLps(nearest) - place_P).norm(), exact_mm);
        ASSERT_EQ(found.voxel(static_cast<int>(nearest.x()), static_cast<int>(nearest.y()),
                              static_cast<int>(nearest.z())),
                  expected.voxel(i, j, k));
      }
}

class DicomReading : public testing::Test {
protected:
  void expectReadBack(const ct::CtVolume& volume)
  {
    const auto place = folder / std::to_string(++count);
    test::writeDicomFiles(test::dicomSlices(volume), place);
    const auto loaded = readCt(place);
    ASSERT_TRUE(loaded) << loaded.error().message;
    expectSame(volume, loaded->volume);
  }

  test::TemporaryFolder folder;
  int count = 0;
};

TEST_F(DicomReading, FindsAxialSlicesWithUnequalPixelSpacingWhereTheyLie)
{
  expectReadBack(smallCt());
}

TEST_F(DicomReading, FindsSagittalSlicesWhereTheyLie)
{
  Eigen::Matrix3d axes;
  axes << 0, 0, -1, 1, 0, 0, 0, -1, 0;
  expectReadBack(smallCt(axes, {0.3, 0.3, 0.6}));
}

TEST_F(DicomReading, FindsObliqueSlicesWhereTheyLie)
{
  const Eigen::Matrix3d axes =
      Eigen::AngleAxisd(0.4, Eigen::Vector3d(0.3, -0.8, 0.5).normalized()).toRotationMatrix();
  expectReadBack(smallCt(axes, {0.15, 0.2, 0.25}));
}

TEST_F(DicomReading, FindsFeetFirstAndProneSlicesWhereTheyLie)
{
  for (const Eigen::Vector3d& signs :
       {Eigen::Vector3d(-1, 1, -1), Eigen::Vector3d(-1, -1, 1), Eigen::Vector3d(1, -1, -1)})
    expectReadBack(smallCt(signs.asDiagonal(), {0.3, 0.4, 0.6}));
}

TEST_F(DicomReading, FindsSlicesThatAreNumberedDownwardWhereTheyLie)
{
  const Eigen::Matrix3d axes = Eigen::Vector3d(1, 1, -1).asDiagonal();
  expectReadBack(smallCt(axes, {0.3, 0.4, 0.6}));
}

TEST_F(DicomReading, ReadsAnEnhancedFileOfManyFrames)
{
  const ct::CtVolume volume = smallCt();
  std::ofstream(folder / "enhanced", std::ios::binary) << test::enhancedDicom(volume).file();
  const auto loaded = readCt(folder / "enhanced");
  ASSERT_TRUE(loaded) << loaded.error().message;
  expectSame(volume, loaded->volume);
}

TEST_F(DicomReading, ReadsTheSeriesThatADicomdirNames)
{
  const ct::CtVolume volume = smallCt();
  test::writeDicomFiles(test::dicomSlices(volume), folder / "IMAGES");
  std::vector<test::DicomData> records;
  for (const auto& entry : std::filesystem::directory_iterator(folder / "IMAGES")) {
    test::DicomData record;
    record.setText(0x00041500, "CS", "IMAGES\\" + entry.path().filename().string());
    records.push_back(record);
  }
  test::DicomData outside;  // names a file beside the medium
  outside.setText(0x00041500, "CS", "..\\IMAGES");
  records.push_back(outside);
  test::DicomData directory;
  directory.setText(0x00080016, "UI", "1.2.840.10008.1.3.10");
  directory.setSequence(0x00041220, records);
  std::ofstream(folder / "DICOMDIR", std::ios::binary) << directory.file();
  for (const char* path : {"DICOMDIR", "."}) {
    const auto loaded = readCt(folder / path);
    ASSERT_TRUE(loaded) << loaded.error().message;
    expectSame(volume, loaded->volume);
  }
}

TEST_F(DicomReading, MeasuresNothingInTheCornersThatATiltLeavesEmpty)
{
  // One intensity in each column of voxels, which the tilt leaves in its place: what is not it was not measured.
  const auto expected = [](int i) { return static_cast<std::int16_t>(i % 2 == 0 ? 1500 : 1200); };
  const double tilt = 15.0 * 3.14159265358979323846 / 180.0;
  Eigen::Matrix4d lps = Eigen::Matrix4d::Identity();
  lps(0, 0) = lps(1, 1) = 0.5;
  lps.block<3, 1>(0, 2) = 0.6 * Eigen::Vector3d(0.0, std::sin(tilt), std::cos(tilt));
  std::vector<std::int16_t> voxels(20 * 40 * 30);
  for (std::size_t at = 0; at < voxels.size(); ++at) voxels[at] = expected(int(at % 20));
  const auto volume = *ct::CtVolume::make({20, 40, 30}, lps, std::move(voxels));
  test::writeDicomFiles(test::dicomSlices(volume), folder / "corners");
  const auto loaded = readCt(folder / "corners");
  ASSERT_TRUE(loaded) << loaded.error().message;
  const ct::CtVolume& straight = loaded->volume;
  int corner = 0, inside = 0;
  for (int k = 0; k < straight.size()[2]; ++k)
    for (int j = 0; j < straight.size()[1]; ++j)
      for (int i = 0; i < straight.size()[0]; ++i) {
        const std::int16_t value = straight.voxel(i, j, k);
        const Eigen::Vector3d index = volume.toIndex(straight.toLps(Eigen::Vector3d(i, j, k)));
        if (index.y() < -0.51 || index.y() > 39.51) {
          EXPECT_EQ(value, ct::unmeasured) << i << " " << j << " " << k;
          ++corner;
        } else if (index.y() > -0.49 && index.y() < 39.49) {
          EXPECT_NEAR(value, expected(i), 2) << i << " " << j << " " << k;
          ++inside;
        }
      }
  EXPECT_GT(corner, 1000);
  EXPECT_GT(inside, 15000);
}

TEST_F(DicomReading, ResamplesATiltedGantryToRightAnglesAndNotesIt)
{
  // Voxels are a linear function of the position, which resampling must reproduce.
  const double tilt = 15.0 * 3.14159265358979323846 / 180.0;
  const Eigen::Matrix3d axes = Eigen::AngleAxisd(tilt, Eigen::Vector3d::UnitX()).toRotationMatrix();
  Eigen::Matrix4d lps = Eigen::Matrix4d::Identity();
  lps.block<3, 1>(0, 0) = 0.5 * axes.col(0);
  lps.block<3, 1>(0, 1) = 0.5 * axes.col(1);
  lps.block<3, 1>(0, 2) = Eigen::Vector3d(0, 0, 0.6);
  lps.block<3, 1>(0, 3) = Eigen::Vector3d(-10, 20, -300);
  const auto valueAt = [](const Eigen::Vector3d& place_P) {
    return 20.0 * (place_P.x() + 10.0) + 25.0 * (place_P.y() - 20.0) + 30.0 * (place_P.z() + 300.0);
  };
  std::vector<std::int16_t> voxels;
  for (int k = 0; k < 30; ++k)
    for (int j = 0; j < 40; ++j)
      for (int i = 0; i < 20; ++i) {
        const Eigen::Vector4d place = lps * Eigen::Vector4d(i, j, k, 1.0);
        voxels.push_back(static_cast<std::int16_t>(std::lround(valueAt(place.head<3>()))));
      }
  const auto volume = *ct::CtVolume::make({20, 40, 30}, lps, std::move(voxels));
  test::writeDicomFiles(test::dicomSlices(volume), folder / "tilted");
  const auto loaded = readCt(folder / "tilted");
  ASSERT_TRUE(loaded) << loaded.error().message;

  const Eigen::Matrix3d found = loaded->volume.lpsFromIndex().topLeftCorner<3, 3>();
  EXPECT_NEAR(found.col(1).dot(found.col(2)), 0.0, 1e-6);
  EXPECT_NEAR(found.col(2).norm(), 0.6 * std::cos(tilt), 1e-6);
  EXPECT_THAT(loaded->volume.provenance().notes,
              testing::ElementsAre(testing::HasSubstr("tilted by 15.0 degrees")));
  EXPECT_THAT(loaded->series.warnings, testing::Contains(testing::HasSubstr("tilted by 15.0")));
  int compared = 0;
  for (const double i : {6.0, 9.3, 13.0})
    for (const double j : {12.0, 19.5, 27.0})
      for (const double k : {10.0, 14.2, 19.0}) {
        const Eigen::Vector3d place_P = volume.toLps({i, j, k});
        const auto value = loaded->volume.sample(place_P);
        ASSERT_TRUE(value);
        EXPECT_NEAR(*value, valueAt(place_P), 1.0);  // half a unit of rounding, twice
        ++compared;
      }
  EXPECT_EQ(compared, 27);
}

TEST_F(DicomReading, DropsSlicesThatAreThereTwice)
{
  const ct::CtVolume volume = smallCt();
  auto slices = test::dicomSlices(volume);
  slices.push_back(slices[3]);
  test::writeDicomFiles(slices, folder / "double");
  const auto loaded = readCt(folder / "double");
  ASSERT_TRUE(loaded) << loaded.error().message;
  expectSame(volume, loaded->volume);
  EXPECT_THAT(loaded->series.warnings,
              testing::Contains(testing::HasSubstr("1 slices lie at the position of another")));
}

TEST_F(DicomReading, LeavesScoutsOut)
{
  const ct::CtVolume volume = smallCt();
  auto slices = test::dicomSlices(volume);
  auto scout = slices.front();
  scout.setText(0x00080008, "CS", "ORIGINAL\\PRIMARY\\LOCALIZER");
  scout.setNumbers(0x00200037, {0, 1, 0, 0, 0, -1});
  slices.push_back(scout);
  test::writeDicomFiles(slices, folder / "scout");
  const auto loaded = readCt(folder / "scout");
  ASSERT_TRUE(loaded) << loaded.error().message;
  expectSame(volume, loaded->volume);
  EXPECT_THAT(loaded->series.warnings, testing::Contains(testing::HasSubstr("1 scout")));
}

TEST_F(DicomReading, AppliesEachSlicesOwnSlopeAndIntercept)
{
  const ct::CtVolume volume = smallCt();
  auto slices = test::dicomSlices(volume);
  for (std::size_t k = 0; k < slices.size(); k += 2) {
    std::vector<std::uint16_t> values;
    for (int j = 0; j < 10; ++j)
      for (int i = 0; i < 12; ++i)
        values.push_back(
            static_cast<std::uint16_t>(2 * (volume.voxel(i, j, static_cast<int>(k)) + 1100)));
    slices[k].setPixels(values);
    slices[k].setNumbers(0x00281052, {-1100});
    slices[k].setNumbers(0x00281053, {0.5});
  }
  test::writeDicomFiles(slices, folder / "slopes");
  const auto loaded = readCt(folder / "slopes");
  ASSERT_TRUE(loaded) << loaded.error().message;
  expectSame(volume, loaded->volume);
}

/// The meta information of a file is in it.
std::string startOf(const std::filesystem::path& file)
{
  std::string start(512, '\0');
  std::ifstream(file, std::ios::binary).read(start.data(), 512);
  return start;
}

// GDCM 3.0.24 writes deflated files for --implicit, implicit ones for --explicit; GDCM 3.0.21 what its options say. Here
// both must give the same voxels, or, deflated, a sentence.
TEST_F(DicomReading, FindsTheSameVoxelsInEveryLosslessCodingOfGdcm)
{
  const ct::CtVolume volume = smallCt(Eigen::Matrix3d::Identity(), {0.3, 0.4, 0.6}, {32, 24, 4});
  test::writeDicomFiles(test::dicomSlices(volume), folder / "raw");
  const std::string deflated = "1.2.840.10008.1.2.1.99";
  bool isAnyDeflated = false;
  for (const char* coding :
       {"--jpeg", "--jpegls", "--j2k", "--rle", "--implicit", "--explicit", "--deflated"}) {
    const auto place = folder / coding;
    std::filesystem::create_directories(place);
    for (const auto& entry : std::filesystem::directory_iterator(folder / "raw")) {
      const std::string name = entry.path().filename().string();
      try {
        const auto done =
            test::run({"gdcmconv", {coding, entry.path(), (place / name).string()}, {}, {}});
        ASSERT_EQ(done.status, 0) << done.err;
      } catch (const std::system_error&) {
        GTEST_SKIP() << "gdcmconv is not there: install libgdcm-tools to test compressed series.";
      }
    }
    const auto loaded = readCt(place);
    const auto first = *std::filesystem::directory_iterator(place);
    if (startOf(first.path()).find(deflated) != std::string::npos) {
      isAnyDeflated = true;
      ASSERT_FALSE(loaded) << coding;
      EXPECT_THAT(loaded.error().message,
                  testing::HasSubstr("4 of 4 files are compressed as a whole"));
      continue;
    }
    ASSERT_TRUE(loaded) << coding << ": " << loaded.error().message;
    expectSame(volume, loaded->volume);
  }
  EXPECT_TRUE(isAnyDeflated);
}

TEST_F(DicomReading, TellsItsProgressAndStopsWhereItIsCanceled)
{
  test::writeDicomFiles(test::dicomSlices(smallCt()), folder / "slices");
  std::vector<double> told;
  ASSERT_TRUE(readCt(folder / "slices", {}, {[&](double done) { told.push_back(done); }, {}}));
  EXPECT_TRUE(std::is_sorted(told.begin(), told.end()));
  EXPECT_NEAR(told.back(), 1.0, 1e-12);
  std::stop_source stop;
  stop.request_stop();
  const auto canceled = readCt(folder / "slices", {}, {{}, stop.get_token()});
  ASSERT_FALSE(canceled);
  EXPECT_EQ(canceled.error().message, "Reading was canceled.");
}

}  // namespace
}  // namespace perilymph::imaging
