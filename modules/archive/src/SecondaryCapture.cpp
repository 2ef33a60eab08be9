// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/archive/SecondaryCapture.h"

#include <dcmtk/dcmdata/dcuid.h>

#include <algorithm>
#include <cstdio>
#include <memory>

#include "Association.h"
#include "CtHeaders.h"
#include "Rows.h"
#include "perilymph/foundation/AtomicFile.h"

namespace perilymph::archive {

namespace fs = std::filesystem;

namespace {

constexpr int maxEdge_px = 8192;
constexpr std::size_t maxDescription = 1024;  // of ST, PS3.5

// Patient and study of the CT: PS3.3 C.7.1.1 and C.7.2.1. Those of type 2 are empty where it has none.
const DcmTagKey ofPatientAndStudy[] = {
    DCM_PatientName, DCM_PatientID,       DCM_PatientBirthDate, DCM_PatientSex,
    DCM_StudyDate,   DCM_StudyTime,       DCM_AccessionNumber,  DCM_ReferringPhysicianName,
    DCM_StudyID,     DCM_StudyInstanceUID};

Result<void> check(const SecondaryCapture& image)
{
  const bool isSize = image.width > 0 && image.height > 0 && image.width <= maxEdge_px &&
                      image.height <= maxEdge_px &&
                      image.rgb.size() == std::size_t{3} * static_cast<std::size_t>(image.width) *
                                              static_cast<std::size_t>(image.height);
  const bool isText = image.description.size() <= maxDescription &&
                      std::all_of(image.description.begin(), image.description.end(),
                                  [](char c) { return c >= ' ' && c <= '~' && c != '\\'; });
  if (!isSize || !isText || !(image.pixel_mm > 0.0))
    return Error{
        "A key image has three bytes for each of its pixels, at most 8192 a side, and a "
        "description of at most 1024 ASCII letters."};
  return checkSoftware(image.software);
}

void put(DcmDataset& data, const DcmTagKey& tag, const std::string& text)
{
  data.putAndInsertString(tag, text.c_str());
}

void putUid(DcmDataset& data, const DcmTagKey& tag, const char* root)
{
  char uid[100] = {};
  put(data, tag, dcmGenerateUniqueIdentifier(uid, root));
}

OFCondition addSources(DcmDataset& data, const Headers& headers)
{
  for (const auto& header : headers) {
    DcmItem* source = nullptr;
    const OFCondition added =
        data.findOrCreateSequenceItem(DCM_SourceImageSequence, source, -2);  // behind the last
    if (added.bad()) return added;
    for (const auto& [from, to] : {std::pair{DCM_SOPClassUID, DCM_ReferencedSOPClassUID},
                                   {DCM_SOPInstanceUID, DCM_ReferencedSOPInstanceUID}})
      source->putAndInsertString(to, textIn(*header->getDataset(), from).c_str());
  }
  return EC_Normal;
}

}  // namespace

Result<void> writeSecondaryCapture(const SecondaryCapture& image, const fs::path& ct,
                                   const fs::path& file)
{
  if (const auto ready = prepareDcmtk(); !ready) return ready;
  if (const auto checked = check(image); !checked) return checked;
  const auto headers = readHeaders(ct, image.seriesKey);
  if (!headers) return headers.error();
  DcmDataset& first = *headers->front()->getDataset();
  DcmFileFormat written;
  DcmDataset& data = *written.getDataset();
  // the CT's own bytes in its own characters; the texts of this program are ASCII
  if (first.tagExistsWithValue(DCM_SpecificCharacterSet))
    first.findAndInsertCopyOfElement(DCM_SpecificCharacterSet, &data);
  for (const DcmTagKey& tag : ofPatientAndStudy)
    if (first.findAndInsertCopyOfElement(tag, &data).bad()) data.insertEmptyElement(tag);
  put(data, DCM_SOPClassUID, UID_SecondaryCaptureImageStorage);
  putUid(data, DCM_SOPInstanceUID, SITE_INSTANCE_UID_ROOT);
  putUid(data, DCM_SeriesInstanceUID, SITE_SERIES_UID_ROOT);
  put(data, DCM_Modality, "OT");
  put(data, DCM_Laterality, image.isRight ? "R" : "L");
  put(data, DCM_SeriesNumber, "1");
  put(data, DCM_InstanceNumber, "1");
  put(data, DCM_SeriesDescription, "Cochlear view");
  put(data, DCM_ConversionType, "WSD");  // of a workstation
  put(data, DCM_Manufacturer, "Perilymph");
  put(data, DCM_ManufacturerModelName, "Perilymph");
  put(data, DCM_SoftwareVersions, image.software);
  put(data, DCM_ImageType, "DERIVED\\SECONDARY");
  put(data, DCM_DerivationDescription, image.description);
  put(data, DCM_BurnedInAnnotation, "NO");
  data.insertEmptyElement(DCM_PatientOrientation);
  char spacing[40] = {};
  std::snprintf(spacing, sizeof spacing, "%.6g\\%.6g", image.pixel_mm, image.pixel_mm);
  put(data, DCM_PixelSpacing, spacing);
  OFCondition done = addSources(data, *headers);
  put(data, DCM_PhotometricInterpretation, "RGB");
  for (const auto& [tag, number] : {std::pair{DCM_SamplesPerPixel, 3},
                                    {DCM_PlanarConfiguration, 0},
                                    {DCM_Rows, image.height},
                                    {DCM_Columns, image.width},
                                    {DCM_BitsAllocated, 8},
                                    {DCM_BitsStored, 8},
                                    {DCM_HighBit, 7},
                                    {DCM_PixelRepresentation, 0}})
    data.putAndInsertUint16(tag, static_cast<Uint16>(number));
  if (done.good())
    done = data.putAndInsertUint8Array(DCM_PixelData, image.rgb.data(),
                                       static_cast<unsigned long>(image.rgb.size()));
  if (done.bad())
    return Error{"The picture cannot be written as a key image of %1: %2.", ct, done.text()};
  return writeWhole(file,
                    [&written](const fs::path& place) {
                      return written.saveFile(place.c_str(), EXS_LittleEndianExplicit).good();
                    },
                    {Links::followed, Audience::owner});
}

}  // namespace perilymph::archive
