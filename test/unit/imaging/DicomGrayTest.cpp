// SPDX-License-Identifier: BSD-3-Clause

// Gray values: slopes, packing, padding, and what is no Hounsfield unit.

#include <gmock/gmock.h>

#include <cmath>
#include <functional>
#include <numbers>

#include "StatedSeries.h"

namespace perilymph::imaging {
namespace {

using test::DicomData;
using testing::Contains;
using testing::HasSubstr;

constexpr int perSlice = 400;

/// Stored values of a slice of a volume, by a function of its Hounsfield units.
template <class Stored>
std::vector<std::uint16_t> storedOf(const ct::CtVolume& volume, int k, Stored stored)
{
  std::vector<std::uint16_t> values;
  for (int j = 0; j < volume.size()[1]; ++j)
    for (int i = 0; i < volume.size()[0]; ++i)
      values.push_back(static_cast<std::uint16_t>(stored(volume.voxel(i, j, k))));
  return values;
}

class DicomGray : public ChangedSeries {
protected:
  void expectVolume(const Files& files, const ct::CtVolume& expected, int tolerance = 0)
  {
    const auto loaded = read(files);
    ASSERT_TRUE(loaded) << loaded.error().message;
    for (int k = 0; k < expected.size()[2]; ++k)
      for (int j = 0; j < expected.size()[1]; ++j)
        for (int i = 0; i < expected.size()[0]; ++i)
          ASSERT_NEAR(loaded->volume.voxel(i, j, k), expected.voxel(i, j, k), tolerance)
              << i << " " << j << " " << k;
  }

  void expectRefusal(const Files& files, const std::string& says)
  {
    const auto loaded = read(files);
    ASSERT_FALSE(loaded) << says;
    EXPECT_THAT(loaded.error().message, HasSubstr(says));
  }
};

TEST_F(DicomGray, RequiresASlopeAboveZero)
{
  for (const double slope : {0.0, -1.0, -1e-9}) {
    Files one = slices, all = slices;
    one[3].setNumbers(tags::slope, {slope});
    for (DicomData& slice : all) slice.setNumbers(tags::slope, {slope});
    expectRefusal(one, "RescaleSlope (0028,1053), is ");
    expectRefusal(all, "must be above 0");
  }
}

TEST_F(DicomGray, RequiresASpanOf100)
{
  for (const double slope : {1e-9, 0.001, 0.03}) {
    for (DicomData& slice : slices) slice.setNumbers(tags::slope, {slope});
    expectRefusal(slices, "span less than 100");
  }
}

TEST_F(DicomGray, NamesASliceWhoseScaleIsNotThatOfItsNeighbors)
{
  for (const double factor : {1.05, 0.9, 2.0, 10.0, 1000.0, 0.1, 0.001}) {
    for (const std::size_t k : {std::size_t{0}, std::size_t{4}, slices.size() - 1}) {
      Files changed = slices;
      changed[k].setNumbers(tags::slope, {factor});
      const auto loaded = read(changed);
      ASSERT_FALSE(loaded) << factor << " in " << k;
      EXPECT_THAT(
          loaded.error().message,
          testing::AnyOf(HasSubstr("The gray values of slice " + std::to_string(k + 1) + " of 10"),
                         HasSubstr("voxels lie beyond")));
    }
  }
  for (const double intercept : {-1000.0, -974.0, 0.0, -2048.0, -102'400.0}) {
    Files changed = slices;
    changed[4].setNumbers(tags::intercept, {intercept});
    EXPECT_FALSE(read(changed)) << intercept;
  }
  // so little that noise hides it: read, and said
  Files changed = slices;
  changed[4].setNumbers(tags::slope, {1.01});
  const auto loaded = read(changed);
  if (loaded) {
    EXPECT_THAT(loaded->series.warnings, Contains(HasSubstr("slope 1.01")));
  }
  changed[4].remove(tags::slope);
  changed[4].remove(tags::intercept);
  EXPECT_FALSE(read(changed)) << "a slice without its intercept";
}

TEST_F(DicomGray, ReadsSlicesThatAreScaledOneByOne)
{
  // each slice by its own largest value, as positron tomographs store them
  std::mt19937 random(5);
  for (std::size_t k = 0; k < slices.size(); ++k) {
    const double slope = 0.2 + 0.001 * static_cast<double>(random() % 800);
    const double intercept = -1100.0 - static_cast<double>(random() % 50);
    slices[k].setPixels(storedOf(volume, static_cast<int>(k), [&](int value) {
      return std::lround((value - intercept) / slope);
    }));
    slices[k].setNumber(tags::stored, 16);
    slices[k].setNumber(tags::highBit, 15);
    slices[k].setNumbers(tags::slope, {slope});
    slices[k].setNumbers(tags::intercept, {intercept});
  }
  expectVolume(slices, volume, 1);
  const auto loaded = read(slices);
  EXPECT_THAT(loaded->series.warnings, Contains(HasSubstr("differ between slices")));
}

TEST_F(DicomGray, ReadsPackedVoxelsOf12Bits)
{
  for (std::size_t k = 0; k < slices.size(); ++k) {
    const auto values =
        storedOf(volume, static_cast<int>(k), [](int value) { return value + 1024; });
    // by PS3.5, annex D: a stream of bits, the lowest first
    std::string bytes((values.size() * 12 + 7) / 8, '\0');
    for (std::size_t i = 0; i < values.size(); ++i)
      for (std::size_t bit = 0; bit < 12; ++bit)
        if ((values[i] >> bit & 1) != 0) {
          const std::size_t at = 12 * i + bit;
          bytes[at / 8] = static_cast<char>(bytes[at / 8] | 1 << at % 8);
        }
    slices[k].setNumber(tags::allocated, 12);
    slices[k].setBytes(tags::pixels, "OW", bytes);
  }
  expectVolume(slices, volume);
}

TEST_F(DicomGray, ReadsSignedVoxelsOfFewerBits)
{
  for (const bool isExtended : {true, false}) {
    for (std::size_t k = 0; k < slices.size(); ++k) {
      slices[k].setPixels(storedOf(volume, static_cast<int>(k),
                                   [&](int value) { return isExtended ? value : value & 0x0FFF; }));
      slices[k].setNumber(tags::isSigned, 1);
      slices[k].setNumbers(tags::intercept, {0.0});
    }
    expectVolume(slices, volume);
  }
}

TEST_F(DicomGray, RefusesVoxelsThatNeedMoreBitsThanTheyHave)
{
  Files fewer = slices, mixed = slices;
  for (DicomData& slice : fewer) {
    slice.setNumber(tags::stored, 10);
    slice.setNumber(tags::highBit, 9);
  }
  expectRefusal(fewer, "BitsStored (0028,0101)");
  // 16 bits of signed values, whose header says 12: bone would become air
  for (std::size_t k = 0; k < mixed.size(); ++k) {
    mixed[k].setPixels(
        storedOf(volume, static_cast<int>(k), [](int value) { return value + 600; }));
    mixed[k].setNumber(tags::isSigned, 1);
  }
  expectRefusal(mixed, "BitsStored (0028,0101)");
  // with an overlay in the bits that are left, the voxels are the others
  Files overlay = slices;
  for (std::size_t k = 0; k < overlay.size(); ++k) {
    overlay[k].setPixels(storedOf(volume, static_cast<int>(k), [](int value) {
      return (value + 1024) | (value % 3 == 0 ? 0x8000 : 0);
    }));
    overlay[k].setNumber(0x60000102, 15);
  }
  expectVolume(overlay, volume);
  Files one = slices;
  one[5].setNumber(tags::isSigned, 1);
  expectRefusal(one, "PixelRepresentation (0028,0103) differs");
}

TEST_F(DicomGray, MarksPaddingAsUnmeasuredAndNotAsClipped)
{
  // corners of a round field of view, as scanners pad it
  const auto isCorner = [](int i, int j) { return std::hypot(i - 9.5, j - 9.5) > 10.0; };
  for (const int padding : {63'000, 60'000}) {
    for (std::size_t k = 0; k < slices.size(); ++k) {
      auto values = storedOf(volume, static_cast<int>(k), [](int value) { return value + 1024; });
      for (int at = 0; at < perSlice; ++at)
        if (isCorner(at % 20, at / 20))
          values[static_cast<std::size_t>(at)] = static_cast<std::uint16_t>(padding);
      slices[k].setPixels(values);
      slices[k].setNumber(tags::stored, 16);
      slices[k].setNumber(tags::highBit, 15);
      slices[k].setNumber(tags::padding, 63'000);
      slices[k].setNumber(tags::paddingLimit, 60'000);
    }
    const auto loaded = read(slices);
    ASSERT_TRUE(loaded) << loaded.error().message;
    for (int j = 0; j < 20; ++j)
      for (int i = 0; i < 20; ++i)
        ASSERT_EQ(loaded->volume.voxel(i, j, 4),
                  isCorner(i, j) ? ct::unmeasured : volume.voxel(i, j, 4));
  }
}

TEST_F(DicomGray, MarksOnlyPaddingAtTheBorderWhereTissueMayHaveItsValue)
{
  // padding of 0 HU: corners are not fluid, and fluid is not padding
  const auto isCorner = [](int i, int j) { return i + j < 6; };
  const auto isFluid = [](int i, int j) { return std::abs(i - 10) < 2 && std::abs(j - 10) < 2; };
  for (std::size_t k = 0; k < slices.size(); ++k) {
    auto values = storedOf(volume, static_cast<int>(k), [](int value) { return value + 1024; });
    for (int at = 0; at < perSlice; ++at)
      if (isCorner(at % 20, at / 20) || isFluid(at % 20, at / 20))
        values[static_cast<std::size_t>(at)] = 1024;
    slices[k].setPixels(values);
    slices[k].setNumber(tags::padding, 1024);
  }
  const auto loaded = read(slices);
  ASSERT_TRUE(loaded) << loaded.error().message;
  EXPECT_EQ(loaded->volume.voxel(2, 2, 4), ct::unmeasured);
  EXPECT_EQ(loaded->volume.voxel(0, 0, 4), ct::unmeasured);
  EXPECT_EQ(loaded->volume.voxel(10, 10, 4), 0);
}

/// A volume of 20 x 40 x 20 voxels of a gantry tilted by so many degrees.
ct::CtVolume tiltedBy(double tilt_deg, const std::function<int(int at)>& valueOf)
{
  const double tilt = tilt_deg * std::numbers::pi / 180.0;
  Eigen::Matrix4d lps = Eigen::Matrix4d::Identity();
  lps.block<3, 1>(0, 0) = Eigen::Vector3d(0.4, 0, 0);
  lps.block<3, 1>(0, 1) = 0.4 * Eigen::Vector3d(0, std::cos(tilt), std::sin(tilt));
  lps.block<3, 1>(0, 2) = Eigen::Vector3d(0, 0, 0.6);
  std::vector<std::int16_t> voxels;
  for (int at = 0; at < 20 * 40 * 20; ++at)
    voxels.push_back(static_cast<std::int16_t>(valueOf(at)));
  return *ct::CtVolume::make({20, 40, 20}, lps, std::move(voxels));
}

TEST_F(DicomGray, MarksWhatATiltLeavesEmpty)
{
  const auto tilted = tiltedBy(15.0, [](int at) { return at % 2 == 0 ? 1000 : 1200; });
  const auto loaded = read(test::dicomSlices(tilted));
  ASSERT_TRUE(loaded) << loaded.error().message;
  const ct::CtVolume& straight = loaded->volume;
  int empty = 0;
  for (int k = 0; k < straight.size()[2]; ++k)
    for (int j = 0; j < straight.size()[1]; ++j)
      for (int i = 0; i < straight.size()[0]; ++i) {
        const Eigen::Vector3d from = tilted.toIndex(straight.toLps({1.0 * i, 1.0 * j, 1.0 * k}));
        const bool isOutside =
            from.minCoeff() < -0.51 || from.x() > 19.51 || from.y() > 39.51 || from.z() > 19.51;
        if (!isOutside) continue;
        ++empty;
        ASSERT_EQ(straight.voxel(i, j, k), ct::unmeasured) << from.transpose();
      }
  EXPECT_GT(empty, 100);
}

TEST_F(DicomGray, KeepsPaddingUnmeasuredBesideATilt)
{
  const auto tilted =
      tiltedBy(10.0, [](int at) { return at % 20 < 6 ? -1024 : 1100 + 100 * (at % 2); });
  Files files = test::dicomSlices(tilted);
  for (DicomData& file : files) file.setNumber(tags::padding, 0);
  const auto loaded = read(files);
  ASSERT_TRUE(loaded) << loaded.error().message;
  const ct::CtVolume& straight = loaded->volume;
  for (int k = 0; k < straight.size()[2]; ++k)
    for (int j = 0; j < straight.size()[1]; ++j)
      for (int i = 0; i < 6; ++i) ASSERT_EQ(straight.voxel(i, j, k), ct::unmeasured) << i;
  EXPECT_NE(straight.voxel(10, 20, straight.size()[2] / 2), ct::unmeasured);
}

TEST_F(DicomGray, SaysWhatIsNoHounsfieldUnit)
{
  const struct {
    test::DicomTag tag;
    const char* type;
    const char* value;
    const char* says;
  } cases[] = {{tags::rescaleType, "LO", "US", "RescaleType (0028,1054) is US"},
               {0x00080070, "LO", "NewTom", "cone-beam"},
               {0x00080070, "LO", "Planmeca", "cone-beam"},
               {0x00080070, "LO", "J.Morita.Mfg.Corp.", "cone-beam"}};
  for (const auto& one : cases) {
    Files changed = slices;
    for (DicomData& slice : changed) slice.setText(one.tag, one.type, one.value);
    const auto loaded = read(changed);
    ASSERT_TRUE(loaded) << loaded.error().message;
    EXPECT_THAT(loaded->volume.provenance().notes, Contains(HasSubstr("not Hounsfield units")));
    EXPECT_THAT(loaded->series.warnings, Contains(HasSubstr(one.says)));
  }
}

}  // namespace
}  // namespace perilymph::imaging
