// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// A small series whose headers state everything twice that the reader compares, alike.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <random>
#include <string>
#include <vector>

#include "perilymph/ct/CtVolume.h"
#include "perilymph/imaging/CtSeries.h"
#include "perilymph/test/DicomWriter.h"
#include "perilymph/test/TemporaryFolder.h"
#include "statements/Warnings.h"

namespace perilymph::imaging {

namespace tags {
inline constexpr test::DicomTag imageType = 0x00080008, sopClass = 0x00080016,
                                mediaClass = 0x00020002, smallest = 0x00280106,
                                largest = 0x00280107, patientPosition = 0x00185100,
                                modality = 0x00080060, patientName = 0x00100010,
                                patientId = 0x00100020, birthDate = 0x00100030, sex = 0x00100040,
                                thickness = 0x00180050, kvp = 0x00180060,
                                spacingBetween = 0x00180088, filter = 0x00181160,
                                diameter = 0x00181100, tilt = 0x00181120, imager = 0x00181164,
                                kernel = 0x00181210, study = 0x0020000D, series = 0x0020000E,
                                seriesNumber = 0x00200011, acquisition = 0x00200012,
                                position = 0x00200032, orientation = 0x00200037,
                                frameOfReference = 0x00200052, imagesInAcquisition = 0x00201002,
                                location = 0x00201041, frames = 0x00280008, rows = 0x00280010,
                                columns = 0x00280011, pixelSpacing = 0x00280030,
                                aspect = 0x00280034, allocated = 0x00280100, stored = 0x00280101,
                                highBit = 0x00280102, isSigned = 0x00280103, padding = 0x00280120,
                                paddingLimit = 0x00280121, intercept = 0x00281052,
                                slope = 0x00281053, rescaleType = 0x00281054,
                                studyDate = 0x00080020, seriesDate = 0x00080021,
                                acquisitionDate = 0x00080022, acquisitionDateTime = 0x0008002A,
                                pixels = 0x7FE00010, instanceNumber = 0x00200013,
                                laterality = 0x00200060, imageLaterality = 0x00200062,
                                patientOrientation = 0x00200020, manufacturer = 0x00080070,
                                bodyPart = 0x00180015, photometric = 0x00280004,
                                grayTables = 0x00283000, realWorld = 0x00409096,
                                instance = 0x00080018, codeValue = 0x00080100, units = 0x004008EA,
                                realIntercept = 0x00409224, realSlope = 0x00409225,
                                tableSizes = 0x00283002;
}  // namespace tags

/// Slices of a sphere in air with noise, so that neighbors are alike, as those of a CT are. 12 bits are stored.
inline ct::CtVolume smoothCt(std::array<int, 3> size = {20, 20, 10},
                             Eigen::Vector3d spacing_mm = {0.4, 0.4, 0.6})
{
  Eigen::Matrix4d lps = Eigen::Matrix4d::Identity();
  lps.topLeftCorner<3, 3>() = spacing_mm.asDiagonal();
  lps.topRightCorner<3, 1>() = Eigen::Vector3d(-30.0, 12.0, -400.0);
  std::mt19937 random(3);
  std::vector<std::int16_t> voxels;
  for (int k = 0; k < size[2]; ++k)
    for (int j = 0; j < size[1]; ++j)
      for (int i = 0; i < size[0]; ++i) {
        const Eigen::Vector3d from(i - 0.5 * size[0], j - 0.5 * size[1], 0.5 * (k - 0.5 * size[2]));
        const int noise = static_cast<int>(random() % 60);
        voxels.push_back(
            static_cast<std::int16_t>(noise + (from.norm() < 0.3 * size[0] ? 1900 : -1000)));
      }
  return *ct::CtVolume::make(size, lps, std::move(voxels), {});
}

/// Every warning can be shown in another language.
inline void expectWorded(const std::vector<Sentence>& found)
{
  for (const Sentence& warning : found) EXPECT_NE(warning.phrase(), nullptr) << warning;
}

/// Slices of a volume with unit steps along z, with all second statements.
inline std::vector<test::DicomData> statedSlices(const ct::CtVolume& volume = smoothCt(),
                                                 const std::string& uid = "1.2.3.4")
{
  auto slices = test::dicomSlices(volume, uid);
  const Eigen::Matrix4d& lps = volume.lpsFromIndex();
  const double step = lps.block<3, 1>(0, 2).norm();
  for (std::size_t k = 0; k < slices.size(); ++k) {
    test::DicomData& slice = slices[k];
    slice.setText(tags::sex, "CS", "F");
    slice.setText(tags::kvp, "DS", "120");
    slice.setText(tags::filter, "SH", "HEAD");
    slice.setNumbers(tags::spacingBetween, {step});
    slice.setNumbers(tags::thickness, {step});
    slice.setNumbers(tags::diameter, {volume.size()[0] * lps.block<3, 1>(0, 0).norm()});
    slice.setNumbers(tags::tilt, {0.0});
    slice.setNumbers(tags::imager, {lps.block<3, 1>(0, 1).norm(), lps.block<3, 1>(0, 0).norm()});
    slice.setText(tags::seriesNumber, "IS", "3");
    slice.setText(tags::acquisition, "IS", "2");
    slice.setText(tags::frameOfReference, "UI", "1.2.3.99");
    slice.setText(tags::imagesInAcquisition, "IS", std::to_string(slices.size()));
    slice.setNumbers(tags::location, {-400.0 + step * static_cast<double>(k)});
    slice.setNumber(tags::stored, 12);
    slice.setNumber(tags::highBit, 11);
    slice.setText(tags::rescaleType, "LO", "HU");
    slice.setText(tags::studyDate, "DA", "20260101");
    slice.setText(tags::patientPosition, "CS", "HFS");
    slice.setText(tags::instanceNumber, "IS", std::to_string(k + 1));
    slice.setText(tags::laterality, "CS", "R");
    slice.setText(tags::imageLaterality, "CS", "R");
    slice.setText(tags::patientOrientation, "CS", "L\\P");
    slice.setText(tags::bodyPart, "CS", "HEAD");
    const auto perSlice = static_cast<std::ptrdiff_t>(volume.size()[0]) * volume.size()[1];
    const auto first = volume.voxels().begin() + static_cast<std::ptrdiff_t>(k) * perSlice;
    const auto [low, high] = std::minmax_element(first, first + perSlice);
    slice.setNumber(tags::smallest, static_cast<std::uint16_t>(*low + 1024));
    slice.setNumber(tags::largest, static_cast<std::uint16_t>(*high + 1024));
  }
  return slices;
}

/// Writes changed files of the series, each time into another folder, and reads them.
class ChangedSeries : public testing::Test {
protected:
  using Files = std::vector<test::DicomData>;

  std::filesystem::path write(const Files& files)
  {
    auto place = folder / std::to_string(++count);
    test::writeDicomFiles(files, place);
    return place;
  }

  Result<LoadedCt> read(const Files& files)
  {
    auto loaded = readCt(write(files));
    if (loaded) expectWorded(loaded->series.warnings);
    return loaded;
  }

  const ct::CtVolume volume = smoothCt();
  Files slices = statedSlices(volume);
  test::TemporaryFolder folder;
  int count = 0;
};

}  // namespace perilymph::imaging
