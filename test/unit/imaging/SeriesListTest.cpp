// SPDX-License-Identifier: BSD-3-Clause

// The list of series in a folder: their order by suitability for a cochlea, and no patient names.

#include <gmock/gmock.h>

#include <algorithm>
#include <fstream>

#include "SmallCt.h"
#include "perilymph/foundation/Sha256.h"
#include "perilymph/imaging/CtSeries.h"
#include "perilymph/test/DicomWriter.h"
#include "perilymph/test/TemporaryFolder.h"

namespace perilymph::imaging {
namespace {

const Eigen::Matrix3d straight = Eigen::Matrix3d::Identity();

/// A folder with a coarse, a fine, a soft and a partial series, a scout and a letter.
class SeriesList : public testing::Test {
protected:
  void SetUp() override
  {
    write("coarse", smallCt(straight, {0.5, 0.5, 1.25}, {64, 64, 30}), "1.1", "Hr64");
    write("fine", smallCt(straight, {0.5, 0.5, 0.6}, {64, 64, 60}), "1.2", "Hr64");
    write("soft", smallCt(straight, {0.5, 0.5, 0.6}, {64, 64, 60}), "1.3", "Br40");
    write("partial", smallCt(straight, {0.5, 0.5, 0.6}, {64, 64, 12}), "1.4", "Hr64");
    auto scout = test::dicomSlices(smallCt(), "1.5").front();
    scout.setText(0x00080008, "CS", "ORIGINAL\\PRIMARY\\LOCALIZER");
    test::writeDicomFiles({scout}, folder / "scout");
    std::ofstream(folder / "letter.txt") << "Dear colleague";
    auto found = findSeries(folder.path());
    ASSERT_TRUE(found) << found.error().message;
    list = *std::move(found);
  }

  void write(const std::string& name, const ct::CtVolume& volume, const std::string& uid,
             const std::string& kernel)
  {
    auto slices = test::dicomSlices(volume, uid);
    for (auto& slice : slices) slice.setText(0x00181210, "SH", kernel);
    test::writeDicomFiles(slices, folder / name);
  }

  const CtSeries& series(const std::string& uid) const
  {
    for (const CtSeries& one : list.series)
      if (one.uid == uid) return one;
    throw std::runtime_error("no series " + uid);
  }

  test::TemporaryFolder folder;
  CtSeriesList list;
};

TEST_F(SeriesList, ProposesTheFineSeriesOfTheWholeBoneWithItsBoneKernelFirst)
{
  ASSERT_EQ(list.series.size(), 5u);
  EXPECT_EQ(list.series.front().uid, "1.2");
  EXPECT_GT(series("1.2").score, series("1.3").score);
  EXPECT_GT(series("1.2").score, series("1.4").score);
  EXPECT_GT(series("1.2").score, series("1.1").score);
  EXPECT_EQ(list.series.back().uid, "1.5");
  EXPECT_EQ(list.series.back().score, 0.0);
  EXPECT_THAT(list.series.back().obstacle, testing::HasSubstr("scout"));
  const auto loaded = readCt(folder.path());
  ASSERT_TRUE(loaded) << loaded.error().message;
  EXPECT_EQ(loaded->series.uid, "1.2");
}

TEST_F(SeriesList, HasAPictureOfEachSeriesThatCanBeRead)
{
  const auto pictures = readThumbnails(list, 32);
  ASSERT_EQ(pictures.size(), 4u);  // not of the scout
  for (const CtThumbnail& picture : pictures) {
    EXPECT_NE(picture.uid, "1.5");
    EXPECT_EQ(picture.width, 32);
    EXPECT_EQ(picture.height, 32);
    ASSERT_EQ(picture.gray.size(), 32u * 32);
    EXPECT_EQ(*std::ranges::max_element(picture.gray), 255);
    EXPECT_EQ(*std::ranges::min_element(picture.gray), 0);
  }
  EXPECT_TRUE(readThumbnails({}, 32).empty());
}

TEST_F(SeriesList, IsReadWithoutListingItsFolderAgain)
{
  // a folder of its own makes the series two phases of the same place, which are refused
  write("second phase",
        smallCt(Eigen::AngleAxisd(0.1, Eigen::Vector3d::UnitZ()).matrix(), {0.5, 0.5, 0.6},
                {64, 64, 60}),
        "1.2", "Hr64");
  EXPECT_FALSE(readCt(folder.path(), "1.2"));
  const auto loaded = readCt(list, "1.2");
  ASSERT_TRUE(loaded) << loaded.error().message;
  EXPECT_EQ(loaded->volume.size(), (std::array{64, 64, 60}));
  EXPECT_EQ(readThumbnails(list, 32).size(), 4u);
}

TEST_F(SeriesList, DescribesEachSeries)
{
  const CtSeries& fine = series("1.2");
  EXPECT_EQ(fine.format, "DICOM");
  EXPECT_EQ(fine.modality, "CT");
  EXPECT_EQ(fine.scanner, "Perilymph Phantom");
  EXPECT_EQ(fine.kernel, "Hr64");
  EXPECT_THAT(fine.size, testing::ElementsAre(64, 64, 60));
  EXPECT_NEAR((fine.spacing_mm - Eigen::Vector3d(0.5, 0.5, 0.6)).norm(), 0.0, 1e-9);
  EXPECT_THAT(fine.warnings, testing::IsEmpty());
  EXPECT_THAT(series("1.1").warnings, testing::Contains(testing::HasSubstr("A voxel is 1.25 mm")));
  EXPECT_THAT(series("1.4").warnings, testing::Contains(testing::HasSubstr("7.20 mm")));
  EXPECT_EQ(list.otherFiles, 1u);
}

TEST_F(SeriesList, HasAKeyForLogsThatDoesNotTellTheUid)
{
  Sha256 hash;
  hash.add(std::string_view("1.2"));
  EXPECT_EQ(series("1.2").key, hash.hex());
  const auto loaded = readCt(folder.path(), "1.3");
  ASSERT_TRUE(loaded) << loaded.error().message;
  EXPECT_EQ(loaded->volume.provenance().seriesKey, series("1.3").key);
}

TEST_F(SeriesList, NamesNoPatient)
{
  for (const CtSeries& one : list.series) {
    std::string all =
        one.uid + one.key + one.format + one.modality + one.scanner + one.kernel + one.obstacle;
    for (const std::string& warning : one.warnings) all += warning;
    for (const char* secret : {"Secretname", "SECRETID", "19010203"})
      EXPECT_THAT(all, testing::Not(testing::HasSubstr(secret)));
  }
}

TEST_F(SeriesList, KeepsFilesWithoutAUidApartByFolder)
{
  auto slices = test::dicomSlices(smallCt());
  for (auto& slice : slices) slice.remove(0x0020000E);
  test::TemporaryFolder two;
  test::writeDicomFiles(slices, two / "a");
  test::writeDicomFiles(slices, two / "b");
  const auto found = findSeries(two.path());
  ASSERT_TRUE(found) << found.error().message;
  ASSERT_EQ(found->series.size(), 2u);
  EXPECT_EQ(found->series.front().uid, "without-uid-1");
  EXPECT_TRUE(readCt(two.path(), "without-uid-2"));
}

}  // namespace
}  // namespace perilymph::imaging
