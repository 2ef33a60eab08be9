// SPDX-License-Identifier: BSD-3-Clause
#include "FrameDecoder.h"

#include <vtkDICOMReader.h>
#include <vtkExecutive.h>
#include <vtkImageData.h>
#include <vtkSmartPointer.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <optional>

#include "../VtkComplaints.h"
#include "CompressedFrames.h"

namespace perilymph::imaging {
namespace {

Error undecodable()
{
  return Error{
      "The voxels of a file could not be decoded: it is damaged, or stored in a way this program "
      "does not know. Copy or export the series again, uncompressed if it can be."};
}

/// Stored values to Hounsfield units, frame by frame.
template <class Stored>
void rescale(const Stored* stored, const DicomHeader& header, DecodedFrames& decoded)
{
  constexpr double low = std::numeric_limits<std::int16_t>::min();
  constexpr double high = std::numeric_limits<std::int16_t>::max();
  const std::size_t perFrame =
      static_cast<std::size_t>(header.rows) * static_cast<std::size_t>(header.columns);
  decoded.voxels.reserve(perFrame * header.frames.size());
  for (const DicomFrame& frame : header.frames)
    for (std::size_t i = 0; i < perFrame; ++i) {
      const double value =
          std::round(frame.slope * static_cast<double>(*stored++) + frame.intercept);
      decoded.clipped += value < low || value > high ? 1 : 0;
      decoded.voxels.push_back(static_cast<std::int16_t>(std::clamp(value, low, high)));
    }
}

void rescaleAs(StoredType type, const void* stored, const DicomHeader& header,
               DecodedFrames& decoded)
{
  switch (type) {
    case StoredType::int8:
      return rescale(static_cast<const std::int8_t*>(stored), header, decoded);
    case StoredType::uint8:
      return rescale(static_cast<const std::uint8_t*>(stored), header, decoded);
    case StoredType::int16:
      return rescale(static_cast<const std::int16_t*>(stored), header, decoded);
    case StoredType::uint16:
      return rescale(static_cast<const std::uint16_t*>(stored), header, decoded);
    case StoredType::int32:
      return rescale(static_cast<const std::int32_t*>(stored), header, decoded);
    case StoredType::uint32:
      return rescale(static_cast<const std::uint32_t*>(stored), header, decoded);
  }
}

std::optional<StoredType> typeOf(int vtkType)
{
  switch (vtkType) {
    case VTK_SIGNED_CHAR:
      return StoredType::int8;
    case VTK_UNSIGNED_CHAR:
      return StoredType::uint8;
    case VTK_SHORT:
      return StoredType::int16;
    case VTK_UNSIGNED_SHORT:
      return StoredType::uint16;
    case VTK_INT:
      return StoredType::int32;
    case VTK_UNSIGNED_INT:
      return StoredType::uint32;
    default:
      return std::nullopt;
  }
}

Result<DecodedFrames> decodePlain(const DicomHeader& header)
{
  const auto complaints = vtkSmartPointer<Complaints>::New();
  const auto reader = vtkSmartPointer<vtkDICOMReader>::New();
  complaints->listenTo({reader, reader->GetExecutive()});
  reader->SetFileName(header.file.c_str());
  reader->SortingOff();  // frames as the file has them; where they lie is known from the header
  reader->AutoRescaleOff();
  reader->AutoYBRToRGBOff();
  reader->SetMemoryRowOrderToFileNative();
  reader->Update();
  vtkImageData& image = *reader->GetOutput();
  const int* const size = image.GetDimensions();
  const auto frames = static_cast<int>(header.frames.size());
  const auto type = typeOf(image.GetScalarType());
  if (complaints->isAny || size[0] != header.columns || size[1] != header.rows ||
      size[2] != frames || image.GetNumberOfScalarComponents() != 1 || !type)
    return undecodable();
  DecodedFrames decoded;
  rescaleAs(*type, image.GetScalarPointer(), header, decoded);
  return decoded;
}

}  // namespace

Result<DecodedFrames> decodeFrames(const DicomHeader& header,
                                   const std::function<bool()>& isCanceled)
{
  if (header.coding != PixelCoding::compressed) return decodePlain(header);
  DecodedFrames decoded;
  const auto use = [&](StoredType type, std::span<const std::byte> bytes) {
    rescaleAs(type, bytes.data(), header, decoded);
  };
  if (!decodeCompressed(header, isCanceled, use)) return undecodable();
  return decoded;
}

}  // namespace perilymph::imaging
