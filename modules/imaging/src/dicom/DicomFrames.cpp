// SPDX-License-Identifier: BSD-3-Clause
#include "DicomFrames.h"

#include <vtkDICOMDictionary.h>
#include <vtkDICOMItem.h>
#include <vtkDICOMSequence.h>

#include "DicomParse.h"
#include "DicomStatements.h"

namespace perilymph::imaging {
namespace {

/// What finds a tag of one frame: in a group of its own, in one of all frames, or in the file.
struct FrameValues {
  const vtkDICOMValue& position;
  const vtkDICOMValue& orientation;
  const vtkDICOMValue& spacing;
  const vtkDICOMValue& thickness;
  const vtkDICOMValue& step;
  const vtkDICOMValue& slope;
  const vtkDICOMValue& intercept;
};

/// The first value of a tag in the functional groups of a frame, or in those of all frames.
const vtkDICOMValue& inGroups(const vtkDICOMSequence& perFrame, const vtkDICOMItem& shared,
                              int frame, vtkDICOMTag group, vtkDICOMTag tag)
{
  if (static_cast<std::size_t>(frame) < perFrame.GetNumberOfItems()) {
    const vtkDICOMValue& own =
        perFrame.GetItem(static_cast<std::size_t>(frame)).Get(group).AsItem().Get(tag);
    if (own.IsValid()) return own;
  }
  return shared.Get(group).AsItem().Get(tag);
}

/// The distances between columns and between rows; DICOM gives that between rows first.
std::optional<Eigen::Vector2d> spacingIn(const vtkDICOMValue& value, vtkDICOMTag tag,
                                         TagNumbers& numbers)
{
  const auto read = numbers.read(value, tag, 2);
  if (!read || !(read->minCoeff() > 0.0)) return std::nullopt;
  return Eigen::Vector2d((*read)[1], (*read)[0]);
}

void fill(DicomFrame& frame, const FrameValues& values, TagNumbers& numbers)
{
  if (const auto place = numbers.read(values.position, DC::ImagePositionPatient, 3))
    frame.pose.position_P = *place;
  if (const auto axes = numbers.read(values.orientation, DC::ImageOrientationPatient, 6)) {
    Eigen::Matrix<double, 3, 2> axes_P;
    axes_P.col(0) = axes->head<3>();
    axes_P.col(1) = axes->tail<3>();
    frame.pose.axes_P = axes_P;
  }
  frame.pixelSpacing_mm = spacingIn(values.spacing, DC::PixelSpacing, numbers);
  frame.thickness_mm = numbers.read(values.thickness, DC::SliceThickness);
  frame.spacing_mm = numbers.read(values.step, DC::SpacingBetweenSlices);
  frame.slope = numbers.read(values.slope, DC::RescaleSlope).value_or(1.0);
  frame.intercept = numbers.read(values.intercept, DC::RescaleIntercept).value_or(0.0);
}

/// What a file of functional groups also states outside of them.
void compareWithGroups(vtkDICOMMetaData& values, TagNumbers& numbers, DicomHeader& header)
{
  if (header.frames.empty()) return;
  const DicomFrame& first = header.frames.front();
  const auto note = [&header](const StatedTwice& pair, double inGroups, double outside) {
    if (auto found = disagreement(header, pair, inGroups, outside))
      header.faults.push_back(*std::move(found));
  };
  const auto spacing = spacingIn(values.Get(DC::PixelSpacing), DC::PixelSpacing, numbers);
  if (spacing && first.pixelSpacing_mm) {
    note(dicomPairs::columnsOutsideGroups, first.pixelSpacing_mm->x(), spacing->x());
    note(dicomPairs::rowsOutsideGroups, first.pixelSpacing_mm->y(), spacing->y());
  }
  if (const auto slope = numbers.read(values.Get(DC::RescaleSlope), DC::RescaleSlope))
    note(dicomPairs::slopeOutsideGroups, first.slope, *slope);
  if (const auto base = numbers.read(values.Get(DC::RescaleIntercept), DC::RescaleIntercept))
    note(dicomPairs::interceptOutsideGroups, first.intercept, *base);
}

}  // namespace

void readFrames(vtkDICOMMetaData& values, TagNumbers& numbers, DicomHeader& header)
{
  const bool isLocalizer = hasValue(values.Get(DC::ImageType), "LOCALIZER");
  const int count =
      numbers.readWhole(values.Get(DC::NumberOfFrames), DC::NumberOfFrames, 1, maxFrames)
          .value_or(1);
  header.frames.resize(static_cast<std::size_t>(count));
  const vtkDICOMValue& groups = values.Get(DC::PerFrameFunctionalGroupsSequence);
  const vtkDICOMValue& sharedGroups = values.Get(DC::SharedFunctionalGroupsSequence);
  const bool hasGroups = groups.IsValid() || sharedGroups.IsValid();
  const vtkDICOMSequence perFrame =
      groups.IsValid() ? vtkDICOMSequence(groups) : vtkDICOMSequence();
  const vtkDICOMItem& shared = sharedGroups.AsItem();
  if (groups.IsValid())
    if (auto found = disagreement(header, dicomPairs::framesAndGroups, count,
                                  static_cast<double>(perFrame.GetNumberOfItems())))
      header.faults.push_back(*std::move(found));
  static const vtkDICOMValue absent;
  for (int i = 0; i < count; ++i) {
    DicomFrame& frame = header.frames[static_cast<std::size_t>(i)];
    frame.isLocalizer = isLocalizer;
    const auto find = [&](vtkDICOMTag group, vtkDICOMTag tag) -> const vtkDICOMValue& {
      return hasGroups ? inGroups(perFrame, shared, i, group, tag) : values.Get(tag);
    };
    // One position cannot be that of many frames.
    const bool hasPlace = hasGroups || count == 1;
    fill(frame,
         {hasPlace ? find(DC::PlanePositionSequence, DC::ImagePositionPatient) : absent,
          hasPlace ? find(DC::PlaneOrientationSequence, DC::ImageOrientationPatient) : absent,
          find(DC::PixelMeasuresSequence, DC::PixelSpacing),
          find(DC::PixelMeasuresSequence, DC::SliceThickness),
          find(DC::PixelMeasuresSequence, DC::SpacingBetweenSlices),
          find(DC::PixelValueTransformationSequence, DC::RescaleSlope),
          find(DC::PixelValueTransformationSequence, DC::RescaleIntercept)},
         numbers);
    if (count == 1 && !hasGroups)
      frame.location_mm = numbers.read(values.Get(DC::SliceLocation), DC::SliceLocation);
  }
  if (hasGroups) compareWithGroups(values, numbers, header);
}

}  // namespace perilymph::imaging
