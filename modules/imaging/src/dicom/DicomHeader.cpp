// SPDX-License-Identifier: BSD-3-Clause
#include "DicomHeader.h"

#include <vtkDICOMItem.h>
#include <vtkDICOMMetaData.h>
#include <vtkDICOMParser.h>
#include <vtkDICOMSequence.h>
#include <vtkDICOMValue.h>
#include <vtkSmartPointer.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <fstream>
#include <initializer_list>
#include <string_view>

#include "../VtkComplaints.h"
#include "Encapsulated.h"
#include "perilymph/foundation/Utf8.h"

namespace perilymph::imaging {
namespace {

constexpr int maxFrames = 20'000;

/// A number that does not depend on the locale; none where the value is absent or no number.
std::optional<double> numberIn(const vtkDICOMValue& value, std::size_t i)
{
  if (!value.IsValid() || i >= value.GetNumberOfValues()) return std::nullopt;
  double number = 0.0;
  if (value.GetVR() == vtkDICOMVR::DS || value.GetVR() == vtkDICOMVR::IS) {
    std::string text = value.GetString(i);
    std::erase_if(text, [](char c) { return c == ' ' || c == '+' || c == '\0'; });
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  } else {
    number = value.GetDouble(i);
  }
  if (!std::isfinite(number)) return std::nullopt;
  return number;
}

std::optional<Eigen::VectorXd> numbersIn(const vtkDICOMValue& value, std::size_t count)
{
  Eigen::VectorXd numbers(static_cast<Eigen::Index>(count));
  for (std::size_t i = 0; i < count; ++i) {
    const auto number = numberIn(value, i);
    if (!number) return std::nullopt;
    numbers[static_cast<Eigen::Index>(i)] = *number;
  }
  return numbers;
}

std::string textIn(const vtkDICOMValue& value)
{
  if (!value.IsValid()) return {};
  std::string text = onOneLine(validUtf8(value.AsUTF8String()));
  while (!text.empty() && (text.back() == ' ' || text.back() == '\0')) text.pop_back();
  constexpr std::size_t maxText = 128;
  if (text.size() > maxText) text = validUtf8(text.substr(0, maxText));
  return text;
}

/// Whether a file begins as DICOM files on media do: 128 bytes, then "DICM".
bool hasPreamble(const std::filesystem::path& file)
{
  std::ifstream stream(file, std::ios::binary);
  std::array<char, 132> start{};
  return stream.read(start.data(), start.size()) &&
         std::string_view(start.data() + 128, 4) == "DICM";
}

/// A UID as it stands, but for its padding: a damaged one must not become a known one.
std::string uidIn(const vtkDICOMValue& value)
{
  std::string text = value.IsValid() ? value.AsString() : std::string();
  if (const auto end = text.find_last_not_of('\0'); end != std::string::npos)
    text.resize(end + 1);
  else
    text.clear();
  return text;
}

bool hasValue(const vtkDICOMValue& value, const char* wanted)
{
  for (std::size_t i = 0; value.IsValid() && i < value.GetNumberOfValues(); ++i)
    if (value.GetString(i) == wanted) return true;
  return false;
}

/// True for a file that begins as DICOM files do, with or without their preamble.
bool beginsAsDicom(const std::filesystem::path& file)
{
  std::array<char, 132> start{};
  std::ifstream stream(file, std::ios::binary);
  stream.read(start.data(), start.size());
  const auto bytes = stream.gcount();
  if (bytes == 132 && std::equal(start.begin() + 128, start.end(), "DICM")) return true;
  return bytes >= 8 && (start[0] == 0x02 || start[0] == 0x08) && start[1] == 0 && start[3] == 0;
}

/// Only what is asked for is kept of a header, so that none is larger than it may be.
vtkSmartPointer<vtkDICOMMetaData> query()
{
  auto query = vtkSmartPointer<vtkDICOMMetaData>::New();
  for (const auto tag : {DC::TransferSyntaxUID,
                         DC::SOPClassUID,
                         DC::SpecificCharacterSet,
                         DC::SeriesInstanceUID,
                         DC::Modality,
                         DC::ImageType,
                         DC::Manufacturer,
                         DC::ManufacturerModelName,
                         DC::ConvolutionKernel,
                         DC::Rows,
                         DC::Columns,
                         DC::SamplesPerPixel,
                         DC::PhotometricInterpretation,
                         DC::BitsAllocated,
                         DC::BitsStored,
                         DC::HighBit,
                         DC::PixelRepresentation,
                         DC::NumberOfFrames,
                         DC::ImagePositionPatient,
                         DC::ImageOrientationPatient,
                         DC::PixelSpacing,
                         DC::RescaleSlope,
                         DC::RescaleIntercept,
                         DC::LossyImageCompression})
    query->Set(tag, vtkDICOMValue(vtkDICOMVR::UN));
  for (const auto tag : {DC::SharedFunctionalGroupsSequence, DC::PerFrameFunctionalGroupsSequence,
                         DC::EncryptedAttributesSequence, DC::DirectoryRecordSequence})
    query->Set(tag, vtkDICOMValue(vtkDICOMSequence()));
  return query;
}

struct Parsed {
  vtkSmartPointer<vtkDICOMMetaData> values;
  bool hasPixels = false, isDamaged = false;
  std::int64_t pixelStart = 0, fileSize = 0;
};

/// Without a query, every element is kept.
std::optional<Parsed> parse(const std::filesystem::path& file, vtkDICOMMetaData* wanted)
{
  if (!beginsAsDicom(file)) return std::nullopt;
  const auto complaints = vtkSmartPointer<Complaints>::New();
  const auto parser = vtkSmartPointer<vtkDICOMParser>::New();
  Parsed parsed;
  parsed.values = vtkSmartPointer<vtkDICOMMetaData>::New();
  complaints->listenTo({parser, parsed.values});
  parser->SetMetaData(parsed.values);
  parser->SetQuery(wanted);
  parser->SetFileName(file.c_str());
  parser->Update();
  parsed.hasPixels = parser->GetPixelDataFound();
  parsed.isDamaged = complaints->isAny;
  parsed.pixelStart = parser->GetFileOffset();
  parsed.fileSize = parser->GetFileSize();
  return parsed;
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

void setPose(DicomFrame& frame, const vtkDICOMValue& position, const vtkDICOMValue& orientation)
{
  if (const auto numbers = numbersIn(position, 3)) frame.pose.position_P = *numbers;
  if (const auto numbers = numbersIn(orientation, 6)) {
    Eigen::Matrix<double, 3, 2> axes;
    axes.col(0) = numbers->head<3>();
    axes.col(1) = numbers->tail<3>();
    frame.pose.axes_P = axes;
  }
}

void setValues(DicomFrame& frame, const vtkDICOMValue& spacing, const vtkDICOMValue& slope,
               const vtkDICOMValue& intercept)
{
  // DICOM gives the distance between rows first.
  if (const auto numbers = numbersIn(spacing, 2); numbers && numbers->minCoeff() > 0.0)
    frame.pixelSpacing_mm = Eigen::Vector2d((*numbers)[1], (*numbers)[0]);
  frame.slope = numberIn(slope, 0).value_or(1.0);
  frame.intercept = numberIn(intercept, 0).value_or(0.0);
}

std::vector<DicomFrame> framesOf(const vtkDICOMMetaData& constValues)
{
  auto& values = const_cast<vtkDICOMMetaData&>(constValues);  // its readers are not const
  const bool isLocalizer = hasValue(values.Get(DC::ImageType), "LOCALIZER");
  const vtkDICOMValue& number = values.Get(DC::NumberOfFrames);
  const double given = numberIn(number, 0).value_or(1.0);
  const int count = given >= 1.0 && given <= maxFrames ? static_cast<int>(given) : 0;
  std::vector<DicomFrame> frames(static_cast<std::size_t>(count));
  const vtkDICOMValue& groups = values.Get(DC::PerFrameFunctionalGroupsSequence);
  const vtkDICOMValue& sharedGroups = values.Get(DC::SharedFunctionalGroupsSequence);
  const bool hasGroups = groups.IsValid() || sharedGroups.IsValid();
  const vtkDICOMSequence perFrame =
      groups.IsValid() ? vtkDICOMSequence(groups) : vtkDICOMSequence();
  const vtkDICOMItem& shared = sharedGroups.AsItem();
  for (int i = 0; i < count; ++i) {
    DicomFrame& frame = frames[static_cast<std::size_t>(i)];
    frame.isLocalizer = isLocalizer;
    if (hasGroups) {
      const auto find = [&](vtkDICOMTag group, vtkDICOMTag tag) -> const vtkDICOMValue& {
        return inGroups(perFrame, shared, i, group, tag);
      };
      setPose(frame, find(DC::PlanePositionSequence, DC::ImagePositionPatient),
              find(DC::PlaneOrientationSequence, DC::ImageOrientationPatient));
      setValues(frame, find(DC::PixelMeasuresSequence, DC::PixelSpacing),
                find(DC::PixelValueTransformationSequence, DC::RescaleSlope),
                find(DC::PixelValueTransformationSequence, DC::RescaleIntercept));
    } else {
      // One position cannot be that of many frames.
      if (count == 1)
        setPose(frame, values.Get(DC::ImagePositionPatient),
                values.Get(DC::ImageOrientationPatient));
      setValues(frame, values.Get(DC::PixelSpacing), values.Get(DC::RescaleSlope),
                values.Get(DC::RescaleIntercept));
    }
  }
  return frames;
}

bool isCutOff(const DicomHeader& header, const Parsed& parsed)
{
  if (!parsed.hasPixels) return false;
  if (header.coding == PixelCoding::compressed)
    return !hasAllFragments(header.file, parsed.pixelStart);
  const std::int64_t bits = static_cast<std::int64_t>(header.rows) * header.columns *
                            header.samples * header.bitsAllocated *
                            static_cast<std::int64_t>(header.frames.size());
  return header.coding == PixelCoding::plain && parsed.pixelStart + bits / 8 > parsed.fileSize;
}

}  // namespace

std::optional<DicomHeader> readDicomHeader(const std::filesystem::path& file)
{
  const auto parsed = parse(file, query());
  if (!parsed) return std::nullopt;
  vtkDICOMMetaData& values = *parsed->values;
  DicomHeader header;
  header.file = file;
  const std::string syntax = uidIn(values.Get(DC::TransferSyntaxUID));
  // a file with a preamble states its coding; where the statement is lost, none is assumed
  header.coding = syntax.empty() && hasPreamble(file) ? PixelCoding::unknown : codingOf(syntax);
  header.transferSyntax = textIn(values.Get(DC::TransferSyntaxUID));
  if (header.coding == PixelCoding::deflated) return header;
  header.seriesUid = textIn(values.Get(DC::SeriesInstanceUID));
  header.sopClass = textIn(values.Get(DC::SOPClassUID));
  header.modality = textIn(values.Get(DC::Modality));
  header.photometric = textIn(values.Get(DC::PhotometricInterpretation));
  header.kernel = textIn(values.Get(DC::ConvolutionKernel));
  header.scanner = textIn(values.Get(DC::Manufacturer));
  if (const std::string model = textIn(values.Get(DC::ManufacturerModelName)); !model.empty())
    header.scanner += (header.scanner.empty() ? "" : " ") + model;
  header.isLossy = textIn(values.Get(DC::LossyImageCompression)) == "01";
  header.rows = values.Get(DC::Rows).AsInt();
  header.columns = values.Get(DC::Columns).AsInt();
  if (const auto samples = numberIn(values.Get(DC::SamplesPerPixel), 0))
    header.samples = static_cast<int>(*samples);
  header.bitsAllocated = values.Get(DC::BitsAllocated).AsInt();
  header.frames = framesOf(values);
  header.isDerived = hasValue(values.Get(DC::ImageType), "DERIVED");
  header.hasPixels = parsed->hasPixels && header.rows > 0 && header.columns > 0;
  header.isEncrypted = values.Has(DC::EncryptedAttributesSequence);
  header.isTruncated = isCutOff(header, *parsed) || (parsed->isDamaged && !header.hasPixels);
  return header;
}

void parseWholeHeader(const std::filesystem::path& file) { parse(file, nullptr); }

std::optional<std::vector<std::filesystem::path>> filesOfDicomDir(const std::filesystem::path& file)
{
  const auto parsed = parse(file, query());
  if (!parsed || !parsed->values->Has(DC::DirectoryRecordSequence)) return std::nullopt;
  const vtkDICOMSequence records(parsed->values->Get(DC::DirectoryRecordSequence));
  std::vector<std::filesystem::path> files;
  for (std::size_t i = 0; i < records.GetNumberOfItems(); ++i) {
    const vtkDICOMValue& id = records.GetItem(i).Get(DC::ReferencedFileID);
    if (!id.IsValid() || id.GetNumberOfValues() == 0) continue;
    std::filesystem::path named = file.parent_path();
    bool isInside = true;
    for (std::size_t k = 0; k < id.GetNumberOfValues(); ++k) {
      std::string part = id.GetString(k);
      while (!part.empty() && part.back() == ' ') part.pop_back();
      isInside = isInside && !part.empty() && part != "." && part != ".." &&
                 part.find('/') == std::string::npos;
      named /= part;
    }
    if (isInside) files.push_back(named);
  }
  return files;
}

}  // namespace perilymph::imaging
