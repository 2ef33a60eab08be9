// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Every pair of statements of DICOM, with files in which both differ by a factor.

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "StatedSeries.h"
#include "dicom/DicomStatements.h"
#include "perilymph/test/DicomWriter.h"

namespace perilymph::imaging {

using test::DicomData;
using testing::HasSubstr;

using Files = std::vector<DicomData>;

inline constexpr double factors[] = {1.01, 1.05, 0.95, 10.0, 1000.0, 0.1};

/// A volume as one file of frames, which states everything alike.
inline DicomData statedFrames()
{
  DicomData file = test::enhancedDicom(smoothCt());
  file.setNumbers(tags::pixelSpacing, {0.4, 0.4});
  file.setNumbers(tags::slope, {1.0});
  file.setNumbers(tags::intercept, {-1024.0});
  return file;
}

inline Files scaledNumber(test::DicomTag tag, double value, double factor)
{
  Files slices = statedSlices();
  for (DicomData& slice : slices) slice.setNumbers(tag, {factor * value});
  return slices;
}

/// One of the slices differs.
inline Files scaledInOne(test::DicomTag tag, double value, double factor)
{
  Files slices = statedSlices();
  slices[4].setNumbers(tag, {factor * value});
  return slices;
}

/// A pair, and files in which its statements differ by a factor; none where the factor makes no file.
struct Case {
  const StatedTwice* pair;
  std::function<Files(double)> make;
};

/// A count, scaled to another whole number.
inline int scaledCount(int count, double factor)
{
  const int scaled = static_cast<int>(std::lround(count * factor));
  return scaled == count ? count + (factor < 1.0 ? -1 : 1) : std::max(1, scaled);
}

/// Frames that state more or fewer than they hold.
inline Files withFrameCount(double factor)
{
  DicomData file = statedFrames();
  file.setText(tags::frames, "IS", std::to_string(scaledCount(10, factor)));
  return {file};
}

/// Voxels of more or fewer frames than the header says, which still holds all that it says.
inline Files withPixels(double factor)
{
  Files slices = statedSlices();
  if (factor < 1.0) factor = 1.0 / factor;
  slices[4].setPixels(
      std::vector<std::uint16_t>(static_cast<std::size_t>(400 * factor + 1.0), 1000));
  return slices;
}

/// Compressed fragments: an offset table and images of the given numbers under one stated frame.
inline Files withFragments(std::uint32_t offsets, int images)
{
  const auto item = [](const std::string& content) {
    std::string bytes = "\xFE\xFF";
    bytes += std::string("\x00\xE0", 2);
    for (int k = 0; k < 4; ++k) bytes += static_cast<char>(content.size() >> (8 * k) & 0xFF);
    return bytes + content;
  };
  std::string bytes = item(std::string(4 * offsets, '\0'));
  for (int i = 0; i < images; ++i) bytes += item("\xFF\xD8\xFF\xD9");
  bytes += std::string("\xFE\xFF\xDD\xE0\0\0\0\0", 8);
  Files slices = statedSlices();
  for (DicomData& slice : slices) slice.setBytes(tags::pixels, "OB", bytes);
  return slices;
}

/// Slices that also give Hounsfield units by a real-world mapping.
inline Files realWorld(double slope, double intercept)
{
  const auto number = [](double value) {
    std::string bytes(sizeof value, '\0');
    std::memcpy(bytes.data(), &value, sizeof value);
    return bytes;
  };
  DicomData units, mapping;
  units.setText(tags::codeValue, "SH", "[hnsf'U]");
  mapping.setSequence(tags::units, {units});
  mapping.setBytes(tags::realIntercept, "FD", number(intercept));
  mapping.setBytes(tags::realSlope, "FD", number(slope));
  Files slices = statedSlices();
  for (DicomData& slice : slices) slice.setSequence(tags::realWorld, {mapping});
  return slices;
}

inline std::vector<Case> cases()
{
  using namespace dicomPairs;
  const auto number = [](test::DicomTag tag, double value) {
    return [tag, value](double factor) { return scaledNumber(tag, value, factor); };
  };
  const auto inOne = [](test::DicomTag tag, double value) {
    return [tag, value](double factor) { return scaledInOne(tag, value, factor); };
  };
  const auto outside = [](test::DicomTag tag, std::vector<double> values, std::size_t place) {
    return [=](double factor) {
      DicomData file = statedFrames();
      auto scaled = values;
      scaled[place] *= factor;
      file.setNumbers(tag, scaled);
      return Files{file};
    };
  };
  return {
      {&framesAndGroups, withFrameCount},
      {&framesAndBytes, withPixels},
      {&framesAndFragments,
       [](double factor) {
         return withFragments(0, scaledCount(1, std::max(2.0, factor / 10.0)));
       }},
      {&framesAndOffsets,
       [](double factor) { return withFragments(factor > 100.0 ? 1000 : 2, 1); }},
      {&highBit,
       [](double factor) {
         Files slices = statedSlices();
         for (DicomData& slice : slices)
           slice.setNumber(tags::highBit,
                           static_cast<std::uint16_t>(std::min(scaledCount(11, factor), 15)));
         return slices;
       }},
      {&bitsStored,
       [](double factor) {
         Files slices = statedSlices();
         const auto bits = static_cast<std::uint16_t>(factor > 100.0 ? 1 : factor > 5.0 ? 4 : 11);
         for (DicomData& slice : slices) {
           slice.setNumber(tags::stored, bits);
           slice.setNumber(tags::highBit, bits - 1);
         }
         return slices;
       }},
      {&columnsOutsideGroups, outside(tags::pixelSpacing, {0.4, 0.4}, 1)},
      {&rowsOutsideGroups, outside(tags::pixelSpacing, {0.4, 0.4}, 0)},
      {&slopeOutsideGroups, outside(tags::slope, {1.0}, 0)},
      {&interceptOutsideGroups, outside(tags::intercept, {-1024.0}, 0)},
      {&aspectRatio,
       [](double factor) {
         Files slices = statedSlices();
         const int height = static_cast<int>(std::lround(1000 * factor));
         for (DicomData& slice : slices)
           slice.setText(tags::aspect, "IS", std::to_string(height) + "\\1000");
         return slices;
       }},
      {&modality,
       [](double) {
         Files slices = statedSlices();
         for (DicomData& slice : slices)
           slice.setText(tags::sopClass, "UI", "1.2.840.10008.5.1.4.1.1.4");
         return slices;
       }},
      {&step, number(tags::spacingBetween, 0.6)},
      {&step, inOne(tags::spacingBetween, 0.6)},
      {&location,
       [](double factor) {
         Files slices = statedSlices();
         for (std::size_t k = 0; k < slices.size(); ++k)
           slices[k].setNumbers(tags::location, {factor * 0.6 * static_cast<double>(k)});
         return slices;
       }},
      {&locationOfSlice, inOne(tags::location, -397.6)},
      {&fieldOfView, number(tags::diameter, 8.0)},
      {&imagerColumns,
       [](double factor) {
         Files slices = statedSlices();
         for (DicomData& slice : slices) slice.setNumbers(tags::imager, {0.4, 0.4 * factor});
         return slices;
       }},
      {&imagerRows,
       [](double factor) {
         Files slices = statedSlices();
         for (DicomData& slice : slices) slice.setNumbers(tags::imager, {0.4 * factor, 0.4});
         return slices;
       }},
      {&tilt, number(tags::tilt, 15.0)},
      {&mediaClass,
       [](double) {
         Files slices = statedSlices();
         slices[4].setText(tags::mediaClass, "UI", "1.2.840.10008.5.1.4.1.1.4");
         return slices;
       }},
      {&smallest,
       [](double factor) { return scaledNumber(tags::smallest, scaledCount(24, factor), 1.0); }},
      {&largest, inOne(tags::largest, 2983.0)},
      {&grayTable,
       [](double) {
         Files slices = statedSlices();
         DicomData table;  // 4096 entries, from 0, of 16 bits
         table.setBytes(tags::tableSizes, "US", std::string("\0\x10\0\0\x10\0", 6));
         slices[4].setSequence(tags::grayTables, {table});
         return slices;
       }},
      {&directions,
       [](double factor) {
         Files slices = statedSlices();
         slices[4].setText(tags::patientOrientation, "CS",
                           factor > 5.0   ? "R\\P"
                           : factor > 1.0 ? "L\\A"
                                          : "P\\L");
         return slices;
       }},
      {&imageNumber,
       [](double factor) {
         Files slices = statedSlices();
         slices[4].setText(tags::instanceNumber, "IS", std::to_string(scaledCount(5, factor)));
         return slices;
       }},
      {&side,
       [](double) {
         Files slices = statedSlices();
         for (DicomData& slice : slices) slice.setText(tags::imageLaterality, "CS", "L");
         return slices;
       }},
      {&realWorldSlope, [](double factor) { return realWorld(factor, -1024.0); }},
      {&realWorldIntercept, [](double factor) { return realWorld(1.0, factor * -1024.0); }},
      {&imagesInAcquisition, [](double factor) {
         Files slices = statedSlices();
         for (DicomData& slice : slices)
           slice.setText(tags::imagesInAcquisition, "IS", std::to_string(scaledCount(10, factor)));
         return slices;
       }}};
}

}  // namespace perilymph::imaging
