// SPDX-License-Identifier: BSD-3-Clause

// Numbers in DICOM headers: what is there and is no number is refused, never a default.

#include <gmock/gmock.h>

#include <random>
#include <string>
#include <vector>

#include "SmallCt.h"
#include "dicom/TagNumbers.h"
#include "perilymph/imaging/CtSeries.h"
#include "perilymph/test/DicomWriter.h"
#include "perilymph/test/TemporaryFolder.h"

namespace perilymph::imaging {
namespace {

using testing::HasSubstr;

/// A text tag that is read as numbers, and how many it holds.
struct NumericTag {
  test::DicomTag tag;
  const char* name;
  const char* type;
  int count;
  const char* one;  ///< A number that it may hold.
};

constexpr NumericTag textTags[] = {{0x00180050, "SliceThickness", "DS", 1, "0.6"},
                                   {0x00180088, "SpacingBetweenSlices", "DS", 1, "0.6"},
                                   {0x00181100, "ReconstructionDiameter", "DS", 1, "3.6"},
                                   {0x00181120, "GantryDetectorTilt", "DS", 1, "0"},
                                   {0x00181164, "ImagerPixelSpacing", "DS", 2, "0.4"},
                                   {0x00200032, "ImagePositionPatient", "DS", 3, "-31.25"},
                                   {0x00200037, "ImageOrientationPatient", "DS", 6, "0"},
                                   {0x00201002, "ImagesInAcquisition", "IS", 1, "8"},
                                   {0x00201041, "SliceLocation", "DS", 1, "1"},
                                   {0x00280008, "NumberOfFrames", "IS", 1, "1"},
                                   {0x00280030, "PixelSpacing", "DS", 2, "0.4"},
                                   {0x00280034, "PixelAspectRatio", "IS", 2, "1"},
                                   {0x00281052, "RescaleIntercept", "DS", 1, "-1024"},
                                   {0x00281053, "RescaleSlope", "DS", 1, "1"}};

/// Texts that are no number, by rules and by chance: each has a character that no number has there.
std::vector<std::string> badNumbers()
{
  std::vector<std::string> bad = {
      "abc",  "nan",  "NaN", "inf",   "-inf",  "a1",   "1a",   "-1024,0", "-1 24", "1+5", "1e",
      "1e+",  "0x10", "+-5", "--1",   "1.2.3", "-",    "+",    ".",       "e5",    "1d3", "1_000",
      "10x4", "1;2",  "1/2", "1e999", "\xB2",  "1 mm", "1\n2", "(1)",     "1f",    "0b1"};
  std::mt19937 random(7);
  const std::string digits = "0123456789.", others = "abcdfghijklmnopqrstuvwxyz_,;:/*()%$#@!?";
  for (int i = 0; i < 40; ++i) {
    std::string text;
    for (int k = 0; k < 5; ++k) text += digits[random() % 10];
    text[random() % 5] = others[random() % others.size()];
    bad.push_back(text);
  }
  return bad;
}

/// A text with as many values as the tag holds, one of which is given.
std::string among(const NumericTag& tag, const std::string& value, int place)
{
  std::string text;
  for (int i = 0; i < tag.count; ++i)
    text += (i > 0 ? "\\" : "") + (i == place ? value : std::string(tag.one));
  return text;
}

class DicomNumbers : public testing::Test {
protected:
  Result<LoadedCt> readWith(test::DicomTag tag, const char* type, const std::string& text)
  {
    auto slices =
        test::dicomSlices(smallCt(Eigen::Matrix3d::Identity(), {0.3, 0.4, 0.6}, {12, 10, 3}));
    slices[1].setText(tag, type, text);
    const auto place = folder / std::to_string(++count);
    test::writeDicomFiles(slices, place);
    return readCt(place);
  }

  test::TemporaryFolder folder;
  int count = 0;
};

TEST_F(DicomNumbers, ThatAreNoneAreRefusedByName)
{
  const std::vector<std::string> bad = badNumbers();
  // each tag with some of the texts, each text with some of the tags
  for (std::size_t t = 0; t < std::size(textTags); ++t)
    for (std::size_t i = t % 5; i < bad.size(); i += 5) {
      const NumericTag& tag = textTags[t];
      const std::string text = among(tag, bad[i], static_cast<int>(i) % tag.count);
      const auto loaded = readWith(tag.tag, tag.type, text);
      ASSERT_FALSE(loaded) << tag.name << " = " << text;
      EXPECT_THAT(loaded.error().message, HasSubstr(tag.name)) << text;
      EXPECT_THAT(loaded.error().message, testing::Not(HasSubstr("\n"))) << text;
    }
}

TEST_F(DicomNumbers, AreAsManyAsTheirTagHolds)
{
  for (const NumericTag& tag : textTags) {
    const std::string more = among(tag, tag.one, 0) + "\\" + tag.one;
    const auto tooMany = readWith(tag.tag, tag.type, more);
    ASSERT_FALSE(tooMany) << tag.name;
    EXPECT_THAT(tooMany.error().message, HasSubstr(tag.name));
    if (tag.count == 1) continue;
    const auto tooFew = readWith(tag.tag, tag.type, tag.one);
    ASSERT_FALSE(tooFew) << tag.name;
    EXPECT_THAT(tooFew.error().message, HasSubstr(tag.name));
  }
}

TEST_F(DicomNumbers, AreReadInAnyRepresentationOfText)
{
  const auto expected = readWith(0x00281053, "DS", "1");
  ASSERT_TRUE(expected) << expected.error().message;
  for (const char* const type : {"DS", "IS", "LO", "SH", "LT", "ST", "UT", "UN", "CS"})
    for (const char* const text : {"-1024", " -1024.0 ", "-1.024e3", "-1024."}) {
      const auto loaded = readWith(0x00281052, type, text);
      ASSERT_TRUE(loaded) << type << ": " << loaded.error().message;
      EXPECT_EQ(loaded->volume.voxel(3, 3, 1), expected->volume.voxel(3, 3, 1)) << type << text;
    }
  for (const char* const type : {"LO", "UN", "LT"}) {
    const auto loaded = readWith(0x00281052, type, "-1024,0");
    ASSERT_FALSE(loaded) << type;
    EXPECT_THAT(loaded.error().message, HasSubstr("RescaleIntercept (0028,1052) as \"-1024,0"));
  }
}

TEST_F(DicomNumbers, ThatAreEmptyAreAbsent)
{
  for (const test::DicomTag tag : {0x00181100u, 0x00201041u, 0x00281053u, 0x00180088u})
    EXPECT_TRUE(readWith(tag, "DS", "")) << std::hex << tag;
  EXPECT_TRUE(readWith(0x00281053, "DS", "  "));
}

TEST_F(DicomNumbers, OfSizesAndBitsAreWholeAndInTheirRange)
{
  const struct {
    test::DicomTag tag;
    const char* name;
    std::vector<std::uint16_t> bad;
  } tags[] = {{0x00280002, "SamplesPerPixel", {0, 5, 65'535}},
              {0x00280010, "Rows", {0}},
              {0x00280011, "Columns", {0}},
              {0x00280100, "BitsAllocated", {0, 65, 65'535}},
              {0x00280101, "BitsStored", {0, 17, 65'535}},
              {0x00280102, "HighBit", {0, 14, 64}},
              {0x00280103, "PixelRepresentation", {2, 256, 65'535}}};
  for (const auto& tag : tags)
    for (const std::uint16_t bad : tag.bad) {
      auto slices = test::dicomSlices(smallCt());
      for (auto& slice : slices) slice.setNumber(tag.tag, bad);
      const auto place = folder / std::to_string(++count);
      test::writeDicomFiles(slices, place);
      const auto loaded = readCt(place);
      ASSERT_FALSE(loaded) << tag.name << " " << bad;
      EXPECT_THAT(loaded.error().message,
                  testing::AnyOf(HasSubstr(tag.name), HasSubstr("bits (0028,0101)")))
          << bad;
    }
  for (const char* const frames : {"0", "-1", "1.5", "20001", "1e9"}) {
    const auto loaded = readWith(0x00280008, "IS", frames);
    ASSERT_FALSE(loaded) << frames;
    EXPECT_THAT(loaded.error().message, HasSubstr("a whole number from 1 to 20000")) << frames;
  }
}

TEST(DecimalNumber, FollowsTheStandard)
{
  const std::pair<const char*, double> good[] = {
      {"1", 1.0},  {"-1", -1.0}, {"+1", 1.0},        {" 1 ", 1.0},   {"1.5", 1.5},
      {".5", .5},  {"5.", 5.0},  {"1e3", 1000.0},    {"1E-3", 1e-3}, {"1.e+2", 100.0},
      {"-0", 0.0}, {"007", 7.0}, {"+1.25E+01", 12.5}};
  for (const auto& [text, value] : good) {
    const auto number = decimalNumber(text);
    ASSERT_TRUE(number) << text;
    EXPECT_EQ(*number, value) << text;
  }
  for (const std::string& text : badNumbers()) EXPECT_FALSE(decimalNumber(text)) << text;
  EXPECT_FALSE(decimalNumber(""));
  EXPECT_FALSE(decimalNumber("  "));
}

}  // namespace
}  // namespace perilymph::imaging
