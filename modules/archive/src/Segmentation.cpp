// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/archive/Segmentation.h"

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmfg/fgderimg.h>
#include <dcmtk/dcmfg/fgfracon.h>
#include <dcmtk/dcmfg/fgpixmsr.h>
#include <dcmtk/dcmfg/fgplanor.h>
#include <dcmtk/dcmfg/fgplanpo.h>
#include <dcmtk/dcmiod/modcommoninstanceref.h>
#include <dcmtk/dcmseg/segdoc.h>
#include <dcmtk/dcmseg/segment.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>

#include "Association.h"
#include "CtHeaders.h"
#include "Rows.h"
#include "SlicedTube.h"
#include "perilymph/foundation/AtomicFile.h"

namespace perilymph::archive {

namespace fs = std::filesystem;

namespace {

/// A slice of the series as its header places it.
struct Slice {
  SlicePlane plane;
  DcmDataset* header = nullptr;
  double height_mm = 0.0;  ///< Along the normal of the slices.
};

std::string componentOf(DcmItem& item, const DcmTagKey& tag, unsigned long index)
{
  OFString text;
  item.findAndGetOFString(tag, text, index);
  return {text.c_str(), text.size()};
}

Result<Slice> sliceOf(DcmDataset& header, const fs::path& ct)
{
  Slice slice;
  slice.header = &header;
  std::array<double, 3> across{}, down{};
  std::array<double, 2> spacing{};  // between rows, between columns
  bool isWhole = true;
  const auto number = [&](const DcmTagKey& tag, std::size_t index) {
    Float64 value = 0.0;
    isWhole = header.findAndGetFloat64(tag, value, static_cast<unsigned long>(index)).good() &&
              std::isfinite(value) && isWhole;
    return value;
  };
  for (std::size_t i = 0; i < 3; ++i) {
    slice.plane.origin[i] = number(DCM_ImagePositionPatient, i);
    across[i] = number(DCM_ImageOrientationPatient, i);
    down[i] = number(DCM_ImageOrientationPatient, i + 3);
  }
  for (std::size_t i = 0; i < 2; ++i) spacing[i] = number(DCM_PixelSpacing, i);
  for (std::size_t i = 0; i < 3; ++i) {
    slice.plane.acrossStep[i] = spacing[1] * across[i];
    slice.plane.downStep[i] = spacing[0] * down[i];
  }
  Uint16 rows = 0, columns = 0;
  header.findAndGetUint16(DCM_Rows, rows);
  header.findAndGetUint16(DCM_Columns, columns);
  slice.plane.rows = rows;
  slice.plane.columns = columns;
  const bool isSingle =
      textIn(header, DCM_NumberOfFrames).empty() || textIn(header, DCM_NumberOfFrames) == "1";
  if (!isWhole || !isSingle || rows == 0 || columns == 0 || !(spacing[0] > 0.0 && spacing[1] > 0.0))
    return Error{
        "A segmentation is written for a series of one slice a file, and %1 holds another. Save "
        "the "
        "surface instead.",
        ct};
  slice.height_mm = slice.plane.origin[0] * (across[1] * down[2] - across[2] * down[1]) +
                    slice.plane.origin[1] * (across[2] * down[0] - across[0] * down[2]) +
                    slice.plane.origin[2] * (across[0] * down[1] - across[1] * down[0]);
  return slice;
}

/// The slices from the bottom up, each place once, all with one orientation and size.
Result<std::vector<Slice>> slicesOf(const Headers& headers, const fs::path& ct)
{
  std::vector<Slice> slices;
  for (const auto& header : headers) {
    auto slice = sliceOf(*header->getDataset(), ct);
    if (!slice) return slice.error();
    slices.push_back(*slice);
  }
  std::sort(slices.begin(), slices.end(),
            [](const Slice& one, const Slice& other) { return one.height_mm < other.height_mm; });
  const auto isSamePlace = [](const Slice& one, const Slice& other) {
    return std::fabs(one.height_mm - other.height_mm) < 1e-3;
  };
  slices.erase(std::unique(slices.begin(), slices.end(), isSamePlace), slices.end());
  const DcmTagKey common[] = {DCM_ImageOrientationPatient, DCM_PixelSpacing,
                              DCM_FrameOfReferenceUID};
  for (const Slice& slice : slices) {
    bool isAlike = slice.plane.rows == slices.front().plane.rows &&
                   slice.plane.columns == slices.front().plane.columns;
    for (const DcmTagKey& tag : common) {
      OFString one, other;
      slice.header->findAndGetOFStringArray(tag, one);
      slices.front().header->findAndGetOFStringArray(tag, other);
      isAlike = isAlike && one == other;
    }
    if (!isAlike)
      return Error{
          "The slices in %1 differ in size, direction or frame of reference. Save the "
          "surface instead.",
          ct};
  }
  if (textIn(*slices.front().header, DCM_FrameOfReferenceUID).empty())
    return Error{
        "The series in %1 states no frame of reference, so a segmentation would lie nowhere. "
        "Save the surface instead.",
        ct};
  return slices;
}

Result<void> check(const Lumen& lumen)
{
  const std::size_t n = lumen.pointsPerRing;
  if (n < 3 || lumen.points_mm.size() < 2 * n || lumen.points_mm.size() % n != 0)
    return Error{"A lumen has at least two whole rings of at least three points."};
  return checkSoftware(lumen.software);
}

/// The one segment, with its codes of SNOMED CT.
OFCondition addSegment(DcmSegmentation& document, const Lumen& lumen)
{
  DcmSegment* segment = nullptr;
  OFCondition done = DcmSegment::create(
      segment, lumen.isRight ? "Lumen of the right cochlea" : "Lumen of the left cochlea",
      CodeSequenceMacro("123037004", "SCT", "Anatomical Structure"),
      CodeSequenceMacro("80169004", "SCT", "Cochlea"),
      lumen.hasMarksByHand ? DcmSegTypes::SAT_SEMIAUTOMATIC : DcmSegTypes::SAT_AUTOMATIC,
      "Fit of the bony lumen in CT");
  if (done.bad()) return done;
  segment->setSegmentDescription(
      "Bony lumen by the fitted model, from the round window to the apex");
  auto* side = lumen.isRight ? new CodeSequenceMacro("24028007", "SCT", "Right")
                             : new CodeSequenceMacro("7771000", "SCT", "Left");
  segment->getSegmentedPropertyTypeModifierCode().push_back(side);
  segment->setRecommendedDisplayCIELabValue(48000, 21000, 34000);  // green
  Uint16 number = 0;
  return document.addSegment(segment, number);
}

/// What all frames share: orientation and size of the voxels.
OFCondition addShared(DcmSegmentation& document, const std::vector<Slice>& slices)
{
  DcmDataset& header = *slices.front().header;
  std::array<std::string, 6> direction;
  for (std::size_t i = 0; i < direction.size(); ++i)
    direction[i] = componentOf(header, DCM_ImageOrientationPatient, static_cast<unsigned long>(i));
  const std::unique_ptr<FGPlaneOrientationPatient> orientation(
      FGPlaneOrientationPatient::createMinimal(direction[0].c_str(), direction[1].c_str(),
                                               direction[2].c_str(), direction[3].c_str(),
                                               direction[4].c_str(), direction[5].c_str()));
  if (!orientation) return EC_IllegalParameter;
  FGPixelMeasures measures;
  OFString spacing;
  header.findAndGetOFStringArray(DCM_PixelSpacing, spacing);
  OFCondition done = measures.setPixelSpacing(spacing);
  const double step_mm = slices.size() < 2 ? 0.0
                                           : (slices.back().height_mm - slices.front().height_mm) /
                                                 static_cast<double>(slices.size() - 1);
  char text[16] = {};  // a DS has at most 16 letters
  std::snprintf(text, sizeof text, "%.8g", step_mm);
  if (done.good() && step_mm > 0.0) done = measures.setSpacingBetweenSlices(text);
  if (done.good() && step_mm > 0.0) done = measures.setSliceThickness(text);
  if (done.good()) done = document.addForAllFrames(*orientation);
  if (done.good()) done = document.addForAllFrames(measures);
  return done;
}

OFCondition addFrame(DcmSegmentation& document, const Slice& slice,
                     std::vector<std::uint8_t>& pixels, Uint32 number)
{
  DcmDataset& header = *slice.header;
  const std::unique_ptr<FGPlanePosPatient> position(
      FGPlanePosPatient::createMinimal(componentOf(header, DCM_ImagePositionPatient, 0).c_str(),
                                       componentOf(header, DCM_ImagePositionPatient, 1).c_str(),
                                       componentOf(header, DCM_ImagePositionPatient, 2).c_str()));
  if (!position) return EC_IllegalParameter;
  FGFrameContent content;
  OFCondition done = content.setStackID("1");
  if (done.good()) done = content.setInStackPositionNumber(number);
  if (done.good()) done = content.setDimensionIndexValues(1, 0);  // of the segment
  if (done.good()) done = content.setDimensionIndexValues(number, 1);
  ImageSOPInstanceReferenceMacro source;
  if (done.good()) done = source.setReferencedSOPClassUID(textIn(header, DCM_SOPClassUID).c_str());
  if (done.good())
    done = source.setReferencedSOPInstanceUID(textIn(header, DCM_SOPInstanceUID).c_str());
  if (done.bad()) return done;
  OFVector<ImageSOPInstanceReferenceMacro> sources;
  sources.push_back(source);
  const std::unique_ptr<FGDerivationImage> derivation(
      DcmSegmentation::createDerivationImageFG(sources, "Fit of the bony lumen"));
  if (!derivation) return EC_IllegalParameter;
  OFVector<FGBase*> groups;
  groups.push_back(position.get());
  groups.push_back(&content);
  groups.push_back(derivation.get());
  return document.addFrame(pixels.data(), 1, groups);
}

OFCondition setHeader(DcmSegmentation& document, const std::vector<Slice>& slices)
{
  DcmDataset& first = *slices.front().header;
  OFCondition done = document.importFromSourceImage(first);
  if (done.good()) done = document.getSeries().setSeriesNumber("1");
  if (done.good()) done = document.getSeries().setSeriesDescription("Cochlear lumen");
  char organization[100] = {};
  dcmGenerateUniqueIdentifier(organization, SITE_INSTANCE_UID_ROOT);
  IODMultiframeDimensionModule& dimensions = document.getDimensions();
  if (done.good())
    done = dimensions.addDimensionIndex(DCM_ReferencedSegmentNumber, organization,
                                        DCM_SegmentIdentificationSequence, "Segment");
  if (done.good())
    done = dimensions.addDimensionIndex(DCM_ImagePositionPatient, organization,
                                        DCM_PlanePositionSequence, "Slice");
  IODReferences references;
  for (const Slice& slice : slices)
    references.add(new IODImageReference(textIn(first, DCM_PatientID).c_str(),
                                         textIn(first, DCM_StudyInstanceUID).c_str(),
                                         textIn(first, DCM_SeriesInstanceUID).c_str(),
                                         textIn(*slice.header, DCM_SOPInstanceUID).c_str(),
                                         textIn(*slice.header, DCM_SOPClassUID).c_str()));
  document.getCommonInstanceReference().addReferences(
      references, textIn(first, DCM_StudyInstanceUID).c_str(), OFTrue);
  return done;
}

}  // namespace

Result<void> writeSegmentation(const Lumen& lumen, const fs::path& ct, const fs::path& file)
{
  if (const auto ready = prepareDcmtk(); !ready) return ready;
  if (const auto checked = check(lumen); !checked) return checked;
  const auto headers = readHeaders(ct, lumen.seriesKey);
  if (!headers) return headers.error();
  const auto all = slicesOf(*headers, ct);
  if (!all) return all.error();
  const SlicedTube tube(lumen.points_mm, lumen.pointsPerRing);
  std::vector<Slice> slices;
  std::vector<std::vector<std::uint8_t>> frames;
  for (const Slice& slice : *all) {
    auto pixels = tube.inside(slice.plane);
    if (pixels.empty()) continue;
    slices.push_back(slice);
    frames.push_back(std::move(pixels));
  }
  if (frames.empty())
    return Error{"The lumen lies in no slice of %1. Give the folder of the CT that was measured.",
                 ct};

  DcmSegmentation* made = nullptr;
  OFCondition done = DcmSegmentation::createBinarySegmentation(
      made, static_cast<Uint16>(slices.front().plane.rows),
      static_cast<Uint16>(slices.front().plane.columns),
      IODGeneralEquipmentModule::EquipmentInfo("Perilymph", "Perilymph", "1",
                                               lumen.software.c_str()),
      ContentIdentificationMacro("1", "LUMEN", "Lumen of the cochlea by a fit", "Perilymph"));
  const std::unique_ptr<DcmSegmentation> document(made);
  if (done.good()) done = setHeader(*document, slices);
  if (done.good()) done = addSegment(*document, lumen);
  if (done.good()) done = addShared(*document, slices);
  for (std::size_t i = 0; i < frames.size() && done.good(); ++i)
    done = addFrame(*document, slices[i], frames[i], static_cast<Uint32>(i + 1));
  DcmFileFormat written;
  if (done.good()) done = document->writeDataset(*written.getDataset());
  // DCMTK 3.7 writes 1, where bit 0 is the only one
  if (done.good()) done = written.getDataset()->putAndInsertUint16(DCM_HighBit, 0);
  if (done.bad())
    return Error{"The lumen cannot be written as a segmentation of %1: %2.", ct, done.text()};
  return writeWhole(file,
                    [&written](const fs::path& place) {
                      return written.saveFile(place.c_str(), EXS_LittleEndianExplicit).good();
                    },
                    {Links::followed, Audience::owner});
}

}  // namespace perilymph::archive
