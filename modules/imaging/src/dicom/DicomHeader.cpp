// SPDX-License-Identifier: BSD-3-Clause
#include "DicomHeader.h"

#include <vtkDICOMDictionary.h>
#include <vtkDICOMItem.h>
#include <vtkDICOMSequence.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <fstream>
#include <string_view>

#include "DicomFrames.h"
#include "DicomParse.h"
#include "DicomStatements.h"
#include "StoredBits.h"
#include "TagNumbers.h"
#include "perilymph/foundation/Sha256.h"
#include "perilymph/foundation/Utf8.h"

namespace perilymph::imaging {
namespace {

/// Whether a file begins as DICOM files on media do: 128 bytes, then "DICM".
bool hasPreamble(const std::filesystem::path& file)
{
  std::ifstream stream(file, std::ios::binary);
  std::array<char, 132> start{};
  return stream.read(start.data(), start.size()) &&
         std::string_view(start.data() + 128, 4) == "DICM";
}

constexpr unsigned short firstOverlayGroup = 0x6000, lastOverlayGroup = 0x601E;

vtkDICOMTag overlayBitPosition(unsigned short group) { return {group, 0x0102}; }

constexpr const char* directoryClass = "1.2.840.10008.1.3.10";

const vtkDICOMTag queried[] = {DC::MediaStorageSOPClassUID,
                               DC::TransferSyntaxUID,
                               DC::SOPClassUID,
                               DC::SpecificCharacterSet,
                               DC::StudyInstanceUID,
                               DC::StudyDate,
                               DC::SeriesDate,
                               DC::AcquisitionDate,
                               DC::AcquisitionDateTime,
                               DC::SeriesInstanceUID,
                               DC::FrameOfReferenceUID,
                               DC::PatientName,
                               DC::PatientID,
                               DC::IssuerOfPatientID,
                               DC::PatientBirthDate,
                               DC::PatientSex,
                               DC::Modality,
                               DC::ImageType,
                               DC::Manufacturer,
                               DC::ManufacturerModelName,
                               DC::ConvolutionKernel,
                               DC::FilterType,
                               DC::KVP,
                               DC::SeriesNumber,
                               DC::AcquisitionNumber,
                               DC::ImagesInAcquisition,
                               DC::ReconstructionDiameter,
                               DC::GantryDetectorTilt,
                               DC::SliceThickness,
                               DC::SpacingBetweenSlices,
                               DC::SliceLocation,
                               DC::Rows,
                               DC::Columns,
                               DC::SamplesPerPixel,
                               DC::PhotometricInterpretation,
                               DC::BitsAllocated,
                               DC::BitsStored,
                               DC::HighBit,
                               DC::PixelRepresentation,
                               DC::PixelPaddingValue,
                               DC::PixelPaddingRangeLimit,
                               DC::SmallestImagePixelValue,
                               DC::LargestImagePixelValue,
                               DC::PatientPosition,
                               DC::PixelAspectRatio,
                               DC::NumberOfFrames,
                               DC::ImagePositionPatient,
                               DC::ImageOrientationPatient,
                               DC::PixelSpacing,
                               DC::ImagerPixelSpacing,
                               DC::RescaleSlope,
                               DC::RescaleIntercept,
                               DC::RescaleType,
                               DC::LossyImageCompression,
                               DC::SOPInstanceUID,
                               DC::InstanceNumber,
                               DC::Laterality,
                               DC::ImageLaterality,
                               DC::PatientOrientation,
                               DC::BodyPartExamined};

vtkSmartPointer<vtkDICOMMetaData> query()
{
  auto query = vtkSmartPointer<vtkDICOMMetaData>::New();
  for (const vtkDICOMTag tag : queried) query->Set(tag, vtkDICOMValue(vtkDICOMVR::UN));
  for (unsigned short group = firstOverlayGroup; group <= lastOverlayGroup; group += 2)
    query->Set(overlayBitPosition(group), vtkDICOMValue(vtkDICOMVR::UN));
  for (const auto tag : {DC::SharedFunctionalGroupsSequence, DC::PerFrameFunctionalGroupsSequence,
                         DC::EncryptedAttributesSequence, DC::ModalityLUTSequence,
                         DC::RealWorldValueMappingSequence})
    query->Set(tag, vtkDICOMValue(vtkDICOMSequence()));
  return query;
}

PixelCoding codingOf(const std::string& syntax)
{
  if (syntax.empty() || syntax == "1.2.840.10008.1.2" || syntax == "1.2.840.10008.1.2.1" ||
      syntax == "1.2.840.10008.1.2.2")
    return PixelCoding::plain;
  if (syntax == "1.2.840.10008.1.2.1.99") return PixelCoding::deflated;
  // JPEG, JPEG lossless, JPEG-LS, JPEG 2000 and run lengths.
  for (const char* const known :
       {"4.50", "4.51", "4.57", "4.70", "4.80", "4.81", "4.90", "4.91", "5"})
    if (syntax == std::string("1.2.840.10008.1.2.") + known) return PixelCoding::compressed;
  return PixelCoding::unknown;
}

/// Tells equal texts from different ones, and nothing else; empty for an empty text.
std::string digest(std::string text)
{
  while (!text.empty() &&
         (text.back() == ' ' || text.back() == '\0' || text.back() == '^' || text.back() == '='))
    text.pop_back();
  if (text.empty()) return {};
  Sha256 hash;
  hash.add(std::string_view(text));
  return hash.hex();
}

DicomIdentity identityOf(vtkDICOMMetaData& values)
{
  const auto text = [&values](vtkDICOMTag tag) {
    const vtkDICOMValue& value = values.Get(tag);
    return value.IsValid() ? value.AsString() : std::string();
  };
  DicomIdentity identity;
  identity.patient = digest(text(DC::PatientID));
  identity.study = digest(text(DC::StudyInstanceUID));
  identity.frameOfReference = digest(text(DC::FrameOfReferenceUID));
  for (const auto tag :
       {DC::PatientName, DC::PatientBirthDate, DC::PatientSex, DC::IssuerOfPatientID})
    identity.others.emplace_back(nameOf(tag), digest(text(tag)));
  return identity;
}

std::vector<std::pair<std::string, std::string>> settingsOf(vtkDICOMMetaData& values)
{
  std::vector<std::pair<std::string, std::string>> settings;
  for (const auto tag :
       {DC::AcquisitionNumber, DC::StudyDate, DC::SeriesNumber, DC::ReconstructionDiameter,
        DC::ImageType, DC::FilterType, DC::KVP, DC::SliceThickness, DC::SpacingBetweenSlices,
        DC::PatientPosition, DC::RescaleType, DC::PhotometricInterpretation, DC::Manufacturer,
        DC::ManufacturerModelName, DC::BodyPartExamined, DC::Laterality, DC::ImageLaterality}) {
    std::string value = textIn(values.Get(tag));
    // a slice of a CT that states no unit is in Hounsfield units (DICOM PS3.3, C.11.1.1.2)
    if (tag == DC::RescaleType && value.empty()) value = "HU";
    settings.emplace_back(nameOf(tag), std::move(value));
  }
  return settings;
}

/// The day of a DICOM date or time (DICOM PS3.5, 6.2: "20261120", "20261120093000.5"); empty if it is none.
std::string dayIn(const std::string& text)
{
  constexpr std::size_t digits = 8;
  if (text.size() < digits || !std::all_of(text.begin(), text.begin() + digits,
                                           [](char c) { return c >= '0' && c <= '9'; }))
    return {};
  const auto number = [&text](std::size_t at, std::size_t count) {
    return std::stoi(text.substr(at, count));
  };
  const std::chrono::year_month_day day{std::chrono::year(number(0, 4)),
                                        std::chrono::month(static_cast<unsigned>(number(4, 2))),
                                        std::chrono::day(static_cast<unsigned>(number(6, 2)))};
  if (!day.ok()) return {};
  return text.substr(0, 4) + "-" + text.substr(4, 2) + "-" + text.substr(6, 2);
}

std::string acquiredIn(vtkDICOMMetaData& values)
{
  for (const auto tag :
       {DC::AcquisitionDate, DC::AcquisitionDateTime, DC::SeriesDate, DC::StudyDate})
    if (std::string day = dayIn(textIn(values.Get(tag))); !day.empty()) return day;
  return {};
}

/// The scale to Hounsfield units in a sequence that may hold others.
std::optional<std::array<double, 2>> realWorldScaleIn(const vtkDICOMValue& mappings)
{
  if (!mappings.IsValid()) return std::nullopt;
  const vtkDICOMSequence items(mappings);
  for (std::size_t i = 0; i < items.GetNumberOfItems(); ++i) {
    const vtkDICOMItem& item = items.GetItem(i);
    const vtkDICOMValue& units = item.Get(DC::MeasurementUnitsCodeSequence);
    const auto slope = decimalNumber(textIn(item.Get(DC::RealWorldValueSlope)));
    const auto intercept = decimalNumber(textIn(item.Get(DC::RealWorldValueIntercept)));
    if (units.IsValid() && slope && intercept &&
        textIn(units.AsItem().Get(DC::CodeValue)).find("hnsf'U") != std::string::npos)
      return std::array{*slope, *intercept};
  }
  return std::nullopt;
}

/// A table of gray values stands instead of slope and intercept, and is not applied.
void checkGrayTable(const vtkDICOMValue& tables, DicomHeader& header)
{
  if (!tables.IsValid() || vtkDICOMSequence(tables).GetNumberOfItems() == 0) return;
  const double slope = header.frames.empty() ? 1.0 : header.frames.front().slope;
  const double entries = tables.AsItem().Get(DC::LUTDescriptor).AsInt();
  if (auto found = disagreement(header, dicomPairs::grayTable, slope, entries))
    header.faults.push_back(*std::move(found));
}

void readGeometry(vtkDICOMMetaData& values, TagNumbers& numbers, DicomHeader& header)
{
  header.rows = numbers.readWhole(values.Get(DC::Rows), DC::Rows, 1, 65'535).value_or(0);
  header.columns = numbers.readWhole(values.Get(DC::Columns), DC::Columns, 1, 65'535).value_or(0);
  readFrames(values, numbers, header);
  const auto pair = [&](vtkDICOMTag tag) -> std::optional<Eigen::Vector2d> {
    const auto read = numbers.read(values.Get(tag), tag, 2);
    if (!read || !(read->minCoeff() > 0.0)) return std::nullopt;
    return Eigen::Vector2d((*read)[1], (*read)[0]);
  };
  header.imagerSpacing_mm = pair(DC::ImagerPixelSpacing);
  header.aspectRatio = pair(DC::PixelAspectRatio);
  header.reconstructionDiameter_mm =
      numbers.read(values.Get(DC::ReconstructionDiameter), DC::ReconstructionDiameter);
  header.gantryTilt_deg = numbers.read(values.Get(DC::GantryDetectorTilt), DC::GantryDetectorTilt);
  header.imagesInAcquisition =
      numbers.readWhole(values.Get(DC::ImagesInAcquisition), DC::ImagesInAcquisition, 0, 1'000'000);
}

void readGrayValues(vtkDICOMMetaData& values, TagNumbers& numbers, DicomHeader& header)
{
  const auto whole = [&](vtkDICOMTag tag, int minimum, int maximum) {
    return numbers.readWhole(values.Get(tag), tag, minimum, maximum);
  };
  header.samples = whole(DC::SamplesPerPixel, 1, 4).value_or(1);
  header.bitsAllocated = whole(DC::BitsAllocated, 1, 64).value_or(0);
  header.bitsStored = whole(DC::BitsStored, 1, 64).value_or(0);
  const auto highBit = whole(DC::HighBit, 0, 63);
  header.highBit = highBit.value_or(std::max(0, header.bitsStored - 1));
  header.isSigned = whole(DC::PixelRepresentation, 0, 1).value_or(0) == 1;
  for (unsigned short group = firstOverlayGroup; group <= lastOverlayGroup; group += 2) {
    const vtkDICOMTag tag = overlayBitPosition(group);
    if (values.Get(tag).IsValid())
      header.hasOverlayBits = header.hasOverlayBits || whole(tag, 0, 63).value_or(0) > 0;
  }
  const auto stored = [&](vtkDICOMTag tag) -> std::optional<double> {
    auto value = numbers.read(values.Get(tag), tag);
    // often written with the other sign than the voxels
    constexpr double words = 65'536.0;
    if (value && header.isSigned && *value >= words / 2) *value -= words;
    if (value && !header.isSigned && *value < 0.0) *value += words;
    return value;
  };
  header.smallest = stored(DC::SmallestImagePixelValue);
  header.largest = stored(DC::LargestImagePixelValue);
  const auto first = stored(DC::PixelPaddingValue), last = stored(DC::PixelPaddingRangeLimit);
  if (first)
    header.padding = {
        {std::min(*first, last.value_or(*first)), std::max(*first, last.value_or(*first))}};
}

}  // namespace

std::string nameOf(const DicomHeader& header)
{
  return onOneLine(validUtf8(header.file.filename().string()));
}

std::optional<DicomHeader> readDicomHeader(const std::filesystem::path& file)
{
  static const vtkSmartPointer<vtkDICOMMetaData> wanted = query();
  const auto parsed = parseDicom(file, wanted);
  if (!parsed) return std::nullopt;
  vtkDICOMMetaData& values = *parsed->values;
  DicomHeader header;
  header.file = file;
  const std::string syntax = uidIn(values.Get(DC::TransferSyntaxUID));
  // a file with a preamble states its coding; where the statement is lost, none is assumed
  header.coding = syntax.empty() && hasPreamble(file) ? PixelCoding::unknown : codingOf(syntax);
  header.transferSyntax = textIn(values.Get(DC::TransferSyntaxUID));
  if (header.coding == PixelCoding::deflated) return header;
  header.isDirectory = uidIn(values.Get(DC::MediaStorageSOPClassUID)) == directoryClass ||
                       uidIn(values.Get(DC::SOPClassUID)) == directoryClass;
  header.identity = identityOf(values);
  header.settings = settingsOf(values);
  header.seriesUid = textIn(values.Get(DC::SeriesInstanceUID));
  header.mediaClass = uidIn(values.Get(DC::MediaStorageSOPClassUID));
  header.sopClass = textIn(values.Get(DC::SOPClassUID));
  header.modality = textIn(values.Get(DC::Modality));
  header.photometric = textIn(values.Get(DC::PhotometricInterpretation));
  header.kernel = textIn(values.Get(DC::ConvolutionKernel));
  header.rescaleType = textIn(values.Get(DC::RescaleType));
  header.acquired = acquiredIn(values);
  header.scanner = textIn(values.Get(DC::Manufacturer));
  if (const std::string model = textIn(values.Get(DC::ManufacturerModelName)); !model.empty())
    header.scanner += (header.scanner.empty() ? "" : " ") + model;
  header.isLossy = textIn(values.Get(DC::LossyImageCompression)) == "01";
  TagNumbers numbers;
  readGeometry(values, numbers, header);
  readGrayValues(values, numbers, header);
  header.instanceUid = uidIn(values.Get(DC::SOPInstanceUID));
  header.instanceNumber = decimalNumber(textIn(values.Get(DC::InstanceNumber)));
  header.laterality = textIn(values.Get(DC::Laterality));
  header.imageLaterality = textIn(values.Get(DC::ImageLaterality));
  header.patientOrientation = textIn(values.Get(DC::PatientOrientation));
  header.realWorldScale = realWorldScaleIn(values.Get(DC::RealWorldValueMappingSequence));
  checkGrayTable(values.Get(DC::ModalityLUTSequence), header);
  header.isDerived = hasValue(values.Get(DC::ImageType), "DERIVED");
  header.hasPixels = parsed->hasPixels && header.rows > 0 && header.columns > 0;
  header.isEncrypted = values.Has(DC::EncryptedAttributesSequence);
  header.pixelStart = parsed->pixelStart;
  if (parsed->hasPixels && parsed->pixelLength != 0xFFFFFFFF)
    header.pixelBytes = parsed->pixelLength;
  header.isTruncated = (parsed->hasPixels && isCutOff(header, parsed->fileSize)) ||
                       (parsed->isDamaged && !header.hasPixels);
  for (const Sentence& fault : numbers.faults())
    header.faults.push_back(
        Sentence{"The file %1 states %2; export the series again as original images.",
                 nameOf(header), fault});
  if (header.hasPixels && !header.isTruncated) checkStoredBits(header);
  return header;
}

void parseWholeHeader(const std::filesystem::path& file) { parseDicom(file, nullptr); }

}  // namespace perilymph::imaging
