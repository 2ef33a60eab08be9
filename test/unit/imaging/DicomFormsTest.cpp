// SPDX-License-Identifier: BSD-3-Clause

// Forms in which hospitals send a CT: media in any spelling, scouts without a mark, flat panels, secondary captures.

#include <gmock/gmock.h>

#include <fstream>
#include <functional>

#include "StatedSeries.h"
#include "dicom/DicomFiles.h"

namespace perilymph::imaging {
namespace {

namespace fs = std::filesystem;

using test::DicomData;
using testing::Contains;
using testing::HasSubstr;

class DicomForms : public ChangedSeries {
protected:
  /// A medium whose DICOMDIR names IMAGES\IM1 and so on, and whose files are named by the test.
  fs::path medium(const std::function<std::string(int)>& nameOf,
                  const std::string& images = "IMAGES")
  {
    const auto place = folder / std::to_string(++count);
    fs::create_directories(place / images);
    std::vector<DicomData> records;
    for (std::size_t k = 0; k < slices.size(); ++k) {
      const int number = static_cast<int>(k) + 1;
      DicomData record;
      record.setText(0x00041500, "CS", "IMAGES\\IM" + std::to_string(number));
      records.push_back(record);
      if (const std::string name = nameOf(number); !name.empty())
        std::ofstream(place / images / name, std::ios::binary) << slices[k].file();
    }
    DicomData directory;
    directory.setText(tags::sopClass, "UI", "1.2.840.10008.1.3.10");
    directory.setSequence(0x00041220, records);
    std::ofstream(place / "DICOMDIR", std::ios::binary) << directory.file();
    return place / "DICOMDIR";
  }
};

TEST_F(DicomForms, OfMediaAreFoundInAnySpelling)
{
  const auto numbered = [](const char* before, const char* behind) {
    return [before, behind](int number) { return before + std::to_string(number) + behind; };
  };
  const struct {
    std::function<std::string(int)> nameOf;
    const char* images;
  } spellings[] = {{numbered("IM", ""), "IMAGES"},       {numbered("im", ""), "images"},
                   {numbered("IM", ".dcm"), "IMAGES"},   {numbered("im", ".DCM"), "Images"},
                   {numbered("IM", ";1"), "IMAGES"},     {numbered("im", ".;1"), "images"},
                   {numbered("im", ".dcm;1"), "images"}, {numbered("Im", ".ima"), "IMAGES"}};
  for (const auto& spelling : spellings) {
    const auto loaded = readCt(medium(spelling.nameOf, spelling.images));
    ASSERT_TRUE(loaded) << loaded.error().message;
    EXPECT_EQ(loaded->volume.size()[2], 10) << spelling.nameOf(1);
    EXPECT_EQ(loaded->series.warnings.size(), 1u) << loaded->series.warnings.back();
  }
}

TEST_F(DicomForms, OfMediaSayWhatIsMissing)
{
  const auto some = readCt(medium(
      [](int number) { return number > 8 ? std::string() : "IM" + std::to_string(number); }));
  ASSERT_TRUE(some) << some.error().message;
  EXPECT_EQ(some->volume.size()[2], 8);
  EXPECT_THAT(some->volume.provenance().notes,
              Contains(HasSubstr("2 of 10 files that the DICOMDIR names are not there")));

  const auto none = readCt(medium([](int number) { return "X" + std::to_string(number); }));
  ASSERT_TRUE(none) << none.error().message;
  EXPECT_EQ(none->volume.size()[2], 10);
  EXPECT_THAT(none->series.warnings,
              Contains(HasSubstr("the files in its folder were read instead")));
}

TEST_F(DicomForms, LeaveALoneImageThatIsNoSliceOut)
{
  DicomData across = slices.front(), larger = slices.front();
  across.setNumbers(tags::orientation, {0, 1, 0, 0, 0, -1});
  larger.setNumber(tags::rows, 40);
  larger.setNumber(tags::columns, 40);
  larger.setPixels(std::vector<std::uint16_t>(1600, 1000));
  larger.setNumbers(tags::position, {-30, 12, -390});
  for (const Files& lone : {Files{across}, Files{larger}, Files{across, larger}}) {
    Files all = slices;
    all.insert(all.begin(), lone.begin(), lone.end());
    for (DicomData& slice : all) slice.remove(tags::imagesInAcquisition);
    const auto loaded = read(all);
    ASSERT_TRUE(loaded) << loaded.error().message;
    EXPECT_EQ(loaded->volume.size(), volume.size());
    EXPECT_THAT(loaded->series.warnings, Contains(HasSubstr("as a scout does; it was left out")));
    EXPECT_EQ(loaded->volume.voxel(10, 10, 5), volume.voxel(10, 10, 5));
  }
  // a slice of the stack is none
  Files turned = slices;
  turned[4].setNumbers(tags::orientation, {0, 1, 0, 0, 0, -1});
  const auto gap = read(turned);
  ASSERT_FALSE(gap);
  EXPECT_THAT(gap.error().message, HasSubstr("1 slice is missing"));
  // three are a series of their own
  Files three = slices;
  for (int i = 0; i < 3; ++i) three.push_back(across);
  EXPECT_FALSE(read(three));
}

TEST_F(DicomForms, WithoutAModalityAreOfTheirClass)
{
  for (DicomData& slice : slices) slice.setText(tags::modality, "CS", "");
  const auto loaded = read(slices);
  ASSERT_TRUE(loaded) << loaded.error().message;
  EXPECT_EQ(loaded->series.modality, "CT");
  EXPECT_THAT(loaded->series.warnings, Contains(HasSubstr("It states no modality")));
  for (DicomData& slice : slices) slice.remove(tags::sopClass);
  const auto neither = read(slices);
  ASSERT_FALSE(neither);
  EXPECT_THAT(neither.error().message, HasSubstr("of the modality (none), not CT"));
  Files mixed = statedSlices(volume);
  mixed[3].setText(tags::modality, "CS", "MR");
  const auto several = read(mixed);
  ASSERT_FALSE(several);
  EXPECT_THAT(several.error().message, HasSubstr("several modalities, CT and MR"));
}

TEST_F(DicomForms, OfOtherXRayDevicesAreReadWhereTheyHaveAPlace)
{
  const struct {
    const char* modality;
    const char* sopClass;
  } kinds[] = {{"XA", "1.2.840.10008.5.1.4.1.1.13.1.1"}, {"DX", "1.2.840.10008.5.1.4.1.1.13.1.2"},
               {"XA", "1.2.840.10008.5.1.4.1.1.12.1"},   {"CT", "1.2.840.10008.5.1.4.1.1.7"},
               {"OT", "1.2.840.10008.5.1.4.1.1.7.3"},    {"", "1.2.840.10008.5.1.4.1.1.7"}};
  for (const auto& kind : kinds) {
    Files files = slices;
    for (DicomData& slice : files) {
      slice.setText(tags::modality, "CS", kind.modality);
      slice.setText(tags::sopClass, "UI", kind.sopClass);
    }
    const auto loaded = read(files);
    ASSERT_TRUE(loaded) << kind.modality << kind.sopClass << loaded.error().message;
    EXPECT_EQ(loaded->volume.voxel(10, 10, 5), volume.voxel(10, 10, 5));
    EXPECT_THAT(loaded->volume.provenance().notes, Contains(HasSubstr("not Hounsfield units")));
    const struct {
      test::DicomTag tag;
      const char* name;
    } places[] = {{tags::position, "ImagePositionPatient"},
                  {tags::orientation, "ImageOrientationPatient"},
                  {tags::pixelSpacing, "PixelSpacing"}};
    for (const auto& place : places) {
      Files without = files;
      for (DicomData& slice : without) slice.remove(place.tag);
      const auto refused = read(without);
      ASSERT_FALSE(refused);
      EXPECT_THAT(refused.error().message,
                  HasSubstr(std::string("without a place in the patient (") + place.name));
    }
  }
  // one file of frames, as flat panels write it
  DicomData frames = test::enhancedDicom(volume);
  frames.setText(tags::modality, "CS", "XA");
  frames.setText(tags::sopClass, "UI", "1.2.840.10008.5.1.4.1.1.13.1.1");
  const auto loaded = read({frames});
  ASSERT_TRUE(loaded) << loaded.error().message;
  EXPECT_EQ(loaded->volume.voxel(10, 10, 5), volume.voxel(10, 10, 5));
}

/// Sequences within sequences, with lengths or without.
std::string nested(int depth, bool isOpen)
{
  const auto length = [](std::size_t value) {
    std::string bytes;
    for (int k = 0; k < 4; ++k) bytes += static_cast<char>(value >> (8 * k) & 0xFF);
    return bytes;
  };
  const std::string head("\x40\x00\x75\x02SQ\0\0", 8), item("\xFE\xFF\x00\xE0", 4);
  std::string bytes;
  for (int i = 0; i < depth; ++i) {
    if (isOpen)
      bytes = head + length(0xFFFFFFFF) + item + length(0xFFFFFFFF) + bytes +
              std::string("\xFE\xFF\x0D\xE0\0\0\0\0\xFE\xFF\xDD\xE0\0\0\0\0", 16);
    else
      bytes = head + length(bytes.size() + 8) + item + length(bytes.size()) + bytes;
  }
  return bytes;
}

TEST_F(DicomForms, OfDeepSequencesAreRefusedBeforeTheyAreParsed)
{
  for (const bool isOpen : {true, false})
    for (const int depth : {1, 5, 16, 17, 1000, 20'000}) {
      const auto place = folder / std::to_string(++count);
      fs::create_directories(place);
      for (std::size_t k = 0; k < slices.size(); ++k) {
        std::string file = slices[k].file();
        // before the voxels, where the tag has its place
        const std::size_t pixels = file.find(std::string("\xE0\x7F\x10\x00OW", 6));
        if (k == 4) file.insert(pixels, nested(depth, isOpen));
        std::ofstream(place / std::to_string(k), std::ios::binary) << file;
      }
      const auto start = std::clock();
      const auto loaded = readCt(place);
      if (depth <= 16) {
        EXPECT_TRUE(loaded) << depth << ": " << loaded.error().message;
        continue;
      }
      ASSERT_FALSE(loaded) << depth;
      EXPECT_THAT(loaded.error().message, HasSubstr("1 slice is missing"));
      const auto list = findSeries(place);
      ASSERT_TRUE(list);
      EXPECT_THAT(list->series.back().obstacle, HasSubstr("deeper than 16"));
      EXPECT_LT(static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC, 1.0) << depth;
    }
}

TEST_F(DicomForms, OfOneFolderHaveATimeInWhichTheyAreListed)
{
  const auto place = folder / "slow";
  test::writeDicomFiles(statedSlices(), place);
  const auto listed = listDicomFiles(place, {}, std::chrono::milliseconds(0));
  ASSERT_FALSE(listed);
  EXPECT_THAT(listed.error().message, HasSubstr("takes more than 5 minutes to list"));
  EXPECT_TRUE(listDicomFiles(place, {}, std::chrono::minutes(1)));
}

}  // namespace
}  // namespace perilymph::imaging
