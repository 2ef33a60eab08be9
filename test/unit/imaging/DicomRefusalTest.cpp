// SPDX-License-Identifier: BSD-3-Clause

// Input that must not become a volume: each gives one error message.

#include <gmock/gmock.h>

#include <fstream>

#include "SmallCt.h"
#include "perilymph/imaging/CtSeries.h"
#include "perilymph/test/DicomWriter.h"
#include "perilymph/test/TemporaryFolder.h"

namespace perilymph::imaging {
namespace {

using testing::HasSubstr;

constexpr test::DicomTag imageType = 0x00080008, sopClass = 0x00080016, modalityTag = 0x00080060,
                         kernel = 0x00181210, position = 0x00200032, orientation = 0x00200037,
                         samples = 0x00280002, photometric = 0x00280004, frameCount = 0x00280008,
                         rows = 0x00280010, pixelSpacing = 0x00280030, pixels = 0x7FE00010;

class DicomRefusal : public testing::Test {
protected:
  /// One error message that contains the cause; no library prints anything.
  void expectRefusal(const std::filesystem::path& path, const std::string& says,
                     const std::string& uid = {})
  {
    testing::internal::CaptureStderr();
    testing::internal::CaptureStdout();
    const auto loaded = readCt(path, uid);
    EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
    ASSERT_FALSE(loaded) << says;
    EXPECT_THAT(loaded.error().message, HasSubstr(says));
    EXPECT_THAT(loaded.error().message, testing::Not(HasSubstr("Secretname")));
    EXPECT_THAT(loaded.error().message, testing::Not(HasSubstr("\n")));
    EXPECT_THAT(loaded.error().message, testing::EndsWith("."));
  }

  /// The same for modified slices of a small CT.
  void expectRefusal(const std::vector<test::DicomData>& files, const std::string& says)
  {
    const auto place = folder / std::to_string(++count);
    test::writeDicomFiles(files, place);
    expectRefusal(place, says);
  }

  std::vector<test::DicomData> slices = test::dicomSlices(smallCt());
  test::TemporaryFolder folder;
  int count = 0;
};

TEST_F(DicomRefusal, NamesMissingSlices)
{
  slices.erase(slices.begin() + 3, slices.begin() + 5);
  expectRefusal(slices, "2 slices are missing, the first behind slice 3 of 6");
}

TEST_F(DicomRefusal, NamesAPlaceWithTwoImagesThatDiffer)
{
  auto other = slices[3];
  std::vector<std::uint16_t> values(120, 1000);
  other.setPixels(values);
  slices.push_back(other);
  expectRefusal(slices, "2 images that differ lie at the position of slice 4 of 8");
}

TEST_F(DicomRefusal, TellsOfTwoPhasesInOneSeries)
{
  auto later = slices;
  for (auto& slice : later) slice.setPixels(std::vector<std::uint16_t>(120, 1500));
  slices.insert(slices.end(), later.begin(), later.end());
  expectRefusal(slices, "several phases or reconstructions");
}

TEST_F(DicomRefusal, NamesASliceOutOfItsPlace)
{
  slices[2].setNumbers(position, {-31.25, 12.5, -400.75 + 1.2 + 0.03});
  expectRefusal(slices, "slice 3 of 8");
}

TEST_F(DicomRefusal, RequiresPositionsAndOrientations)
{
  for (const test::DicomTag tag : {position, orientation}) {
    auto without = slices;
    for (auto& slice : without) slice.remove(tag);
    expectRefusal(without, "8 of 8 slices have no position or orientation");
  }
  slices[5].remove(position);
  expectRefusal(slices, "1 of 8 slices have no position");
}

TEST_F(DicomRefusal, DoesNotTakeOnePositionForThatOfManyFrames)
{
  // as dental cone-beam scanners write them
  auto volume = slices.front();
  volume.setText(frameCount, "IS", "3");
  volume.setPixels(std::vector<std::uint16_t>(360, 1000));
  expectRefusal({volume}, "3 of 3 slices have no position or orientation");
}

TEST_F(DicomRefusal, RequiresOneOrientationSizeAndSpacing)
{
  auto turned = slices;
  turned[7].setNumbers(orientation, {0, 1, 0, -1, 0, 0});
  expectRefusal(turned, "1 of 8 slices have another orientation");

  auto smaller = slices;
  for (const std::size_t k : {5, 6, 7}) {
    smaller[k].setNumber(rows, 5);
    smaller[k].setPixels(std::vector<std::uint16_t>(60, 1000));
  }
  expectRefusal(smaller, "12 x 10 and 12 x 5 voxels");

  auto finer = slices;
  finer[7].setNumbers(pixelSpacing, {0.2, 0.2});
  expectRefusal(finer, "several pixel spacings");

  auto without = slices;
  for (auto& slice : without) slice.remove(pixelSpacing);
  expectRefusal(without, "no pixel spacing");

  auto softer = slices;
  softer[7].setText(kernel, "SH", "Br40");
  expectRefusal(softer, "several reconstruction kernels");
}

TEST_F(DicomRefusal, RefusesImagesThatAreNoCt)
{
  auto magnetic = slices, screen = slices, scouts = slices, colored = slices;
  for (auto& slice : magnetic) slice.setText(modalityTag, "CS", "MR");
  expectRefusal(magnetic, "of the modality MR, not CT");
  for (auto& slice : screen) {
    slice.setText(sopClass, "UI", "1.2.840.10008.5.1.4.1.1.7");
    slice.remove(position);
  }
  expectRefusal(screen, "a secondary capture");
  for (auto& slice : scouts) slice.setText(imageType, "CS", "ORIGINAL\\PRIMARY\\LOCALIZER");
  expectRefusal(scouts, "a scout (localizer)");
  for (auto& slice : colored) {
    slice.setNumber(samples, 3);
    slice.setText(photometric, "CS", "RGB");
    slice.setPixels(std::vector<std::uint16_t>(360, 77));
  }
  expectRefusal(colored, "in color");
}

TEST_F(DicomRefusal, TellsOfFilesThatAreCutOffAnywhere)
{
  test::writeDicomFiles(slices, folder / "cut");
  const auto file = std::filesystem::directory_iterator(folder / "cut")->path();
  const auto whole = std::filesystem::file_size(file);
  for (const auto bytes : {whole - 1, whole - 100, whole - 239}) {
    std::filesystem::resize_file(file, bytes);
    expectRefusal(folder / "cut", "1 of 8 files are cut off");
  }
  // A file truncated in its header looks like a file without an image, or like no DICOM file at
  // all; then a slice is missing.
  for (std::uintmax_t bytes = whole - 240; bytes > 0; bytes -= std::min<std::uintmax_t>(7, bytes)) {
    std::filesystem::resize_file(file, bytes);
    ASSERT_FALSE(readCt(folder / "cut", "1.2.3.4")) << bytes;
  }
}

TEST_F(DicomRefusal, TellsOfEncryptedFiles)
{
  test::DicomData secret;
  secret.setText(0x04000510, "UI", "1.2.840.10008.1.2.1");
  for (auto& slice : slices) {
    slice.setSequence(0x04000500, {secret});
    slice.remove(position);
    slice.remove(pixels);
  }
  expectRefusal(slices, "8 of 8 files are encrypted");
}

TEST_F(DicomRefusal, NamesACodingThatItDoesNotKnow)
{
  const std::string highThroughput = "1.2.840.10008.1.2.4.201";
  for (std::size_t i = 0; i < slices.size(); ++i)
    std::ofstream(folder / std::to_string(i), std::ios::binary) << slices[i].file(highThroughput);
  expectRefusal(folder.path(), "transfer syntax " + highThroughput);
}

TEST_F(DicomRefusal, AssumesNoCodingWhereItsStatementIsDamaged)
{
  // An unknown transfer syntax must not be read as an uncompressed one.
  for (const char* const damaged : {"1.2.840.10008.1.2.1\n", ""}) {
    for (std::size_t i = 0; i < slices.size(); ++i)
      std::ofstream(folder / std::to_string(i), std::ios::binary) << slices[i].file(damaged);
    expectRefusal(folder.path(), "transfer syntax");
  }
}

TEST_F(DicomRefusal, RefusesACompressedFileWithoutItsFragments)
{
  const std::string lossless = "1.2.840.10008.1.2.4.70";
  const auto write = [&](const std::string& fragments) {
    for (std::size_t i = 0; i < slices.size(); ++i) {
      slices[i].setBytes(pixels, "OB", fragments);
      std::ofstream(folder / std::to_string(i), std::ios::binary) << slices[i].file(lossless);
    }
  };
  using namespace std::string_literals;
  const std::string offsets = "\xFE\xFF\x00\xE0\0\0\0\0"s;
  const std::string fragment = "\xFE\xFF\x00\xE0\x04\0\0\0"s + "\xFF\xD8\xFF\xD9"s;
  write(offsets + fragment);
  expectRefusal(folder.path(), "8 of 8 files are cut off");
  write(offsets + fragment + "\xFE\xFF\xDD\xE0\0\0\0\0"s);
  expectRefusal(folder.path(), "could not be decoded");
}

TEST_F(DicomRefusal, DoesNotClipWhat16BitsDoNotHold)
{
  for (auto& slice : slices) {
    slice.setPixels(std::vector<std::uint16_t>(120, 60'000));
    slice.setNumbers(0x00281052, {0});
  }
  expectRefusal(slices, "960 voxels lie beyond -32768 to 32767");
}

TEST_F(DicomRefusal, LimitsTheVoxelsBeforeItAllocatesThem)
{
  // Sizes in the header that no file has: a thousand frames of 65535 x 65535.
  auto huge = slices.front();
  huge.setText(frameCount, "IS", "1000");
  huge.setNumber(rows, 65'535);
  huge.setNumber(0x00280011, 65'535);
  expectRefusal({huge}, "cut off");
}

TEST_F(DicomRefusal, AnswersForPathsWithoutASeries)
{
  expectRefusal(folder / "nowhere", "does not exist");
  std::filesystem::create_directories(folder / "empty");
  expectRefusal(folder / "empty", "holds no DICOM image");
  std::ofstream(folder / "notes.txt") << "A CT was made.";
  expectRefusal(folder / "notes.txt", "holds no DICOM image");
  expectRefusal("/dev/null", "neither a file nor a folder");
  test::writeDicomFiles(slices, folder / "one");
  expectRefusal(folder / "one", "holds no series 9.9", "9.9");
  expectRefusal({slices.front()}, "There is a single slice");
}

TEST_F(DicomRefusal, SaysWhereADicomdirsFilesShouldBe)
{
  test::DicomData record, directory;
  record.setText(0x00041500, "CS", "IMAGES\\IM1");
  directory.setText(sopClass, "UI", "1.2.840.10008.1.3.10");
  directory.setSequence(0x00041220, {record});
  std::ofstream(folder / "DICOMDIR", std::ios::binary) << directory.file();
  expectRefusal(folder / "DICOMDIR", "none of the files it names is there");
}

// vtk-dicom asserts that a fragment is shorter than 4 GiB, and so ended the program.
TEST_F(DicomRefusal, OutlivesAFragmentLongerThanItsFile)
{
  using namespace std::string_literals;
  test::writeDicomFiles(slices, folder / "whole");
  std::filesystem::create_directories(folder / "with");
  std::string damaged = slices.front().file();
  const std::size_t manufacturer = damaged.find("\x08\0\x70\0LO"s);
  ASSERT_NE(manufacturer, std::string::npos);
  damaged.insert(manufacturer, "\x08\0\x70\0OB\0\0\xFF\xFF\xFF\xFF\xFE\xFF\0\xE0\xFA\xFF\xFF\xFF"s);
  std::ofstream(folder / "with" / "damaged", std::ios::binary) << damaged;
  expectRefusal(folder / "with", "1 of 1 files are cut off");
  expectRefusal(folder / "with" / "damaged", "1 of 1 files are cut off");
  // Beside a whole series it takes nothing away.
  std::filesystem::copy(folder / "with" / "damaged", folder / "whole" / "damaged");
  EXPECT_TRUE(readCt(folder / "whole"));
  // A DICOMDIR that names it.
  test::DicomData record, directory;
  record.setText(0x00041500, "CS", "WITH\\DAMAGED");
  directory.setText(sopClass, "UI", "1.2.840.10008.1.3.10");
  directory.setSequence(0x00041220, {record});
  std::ofstream(folder / "DICOMDIR", std::ios::binary) << directory.file();
  std::filesystem::rename(folder / "with", folder / "WITH");
  std::filesystem::rename(folder / "WITH" / "damaged", folder / "WITH" / "DAMAGED");
  expectRefusal(folder / "DICOMDIR", "1 of 1 files are cut off");
}

TEST_F(DicomRefusal, CountsFilesBeforeItReadsThem)
{
  std::filesystem::create_directories(folder / "many");
  for (std::size_t i = 0; i <= maxCtFiles; ++i)
    std::ofstream(folder / "many" / std::to_string(i)) << "";
  expectRefusal(folder / "many", "more than 20000 files");
}

}  // namespace
}  // namespace perilymph::imaging
