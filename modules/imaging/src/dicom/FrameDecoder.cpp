#include "FrameDecoder.h"

#include <gdcmImage.h>
#include <gdcmImageReader.h>
#include <vtkDICOMReader.h>
#include <vtkExecutive.h>
#include <vtkImageData.h>
#include <vtkSmartPointer.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include "../VtkComplaints.h"
#include "SilencedStandardError.h"

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

bool rescaleAs(int type, const void* stored, const DicomHeader& header, DecodedFrames& decoded)
{
  switch (type) {
    case VTK_SIGNED_CHAR:
      rescale(static_cast<const std::int8_t*>(stored), header, decoded);
      return true;
    case VTK_UNSIGNED_CHAR:
      rescale(static_cast<const std::uint8_t*>(stored), header, decoded);
      return true;
    case VTK_SHORT:
      rescale(static_cast<const std::int16_t*>(stored), header, decoded);
      return true;
    case VTK_UNSIGNED_SHORT:
      rescale(static_cast<const std::uint16_t*>(stored), header, decoded);
      return true;
    case VTK_INT:
      rescale(static_cast<const std::int32_t*>(stored), header, decoded);
      return true;
    case VTK_UNSIGNED_INT:
      rescale(static_cast<const std::uint32_t*>(stored), header, decoded);
      return true;
    default:
      return false;
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
  DecodedFrames decoded;
  if (complaints->isAny || size[0] != header.columns || size[1] != header.rows ||
      size[2] != frames || image.GetNumberOfScalarComponents() != 1 ||
      !rescaleAs(image.GetScalarType(), image.GetScalarPointer(), header, decoded))
    return undecodable();
  return decoded;
}

/// Type of VTK's for what GDCM gives.
int typeOf(const gdcm::PixelFormat& format)
{
  const bool isSigned = format.GetPixelRepresentation() == 1;
  switch (format.GetBitsAllocated()) {
    case 8:
      return isSigned ? VTK_SIGNED_CHAR : VTK_UNSIGNED_CHAR;
    case 16:
      return isSigned ? VTK_SHORT : VTK_UNSIGNED_SHORT;
    case 32:
      return isSigned ? VTK_INT : VTK_UNSIGNED_INT;
    default:
      return VTK_VOID;
  }
}

/// GDCM says whether it succeeded; vtkDICOMReader, which calls it, does not ask.
Result<DecodedFrames> decodeCompressed(const DicomHeader& header)
{
  std::vector<char> bytes;
  int type = VTK_VOID;
  {
    const SilencedStandardError silenced;
    gdcm::ImageReader reader;
    reader.SetFileName(header.file.c_str());
    if (!reader.Read()) return undecodable();
    const gdcm::Image& image = reader.GetImage();
    const gdcm::PixelFormat& format = image.GetPixelFormat();
    type = typeOf(format);
    const std::size_t expected = static_cast<std::size_t>(header.rows) *
                                 static_cast<std::size_t>(header.columns) * header.frames.size() *
                                 (format.GetBitsAllocated() / 8u);
    if (format.GetSamplesPerPixel() != 1 || image.GetBufferLength() != expected)
      return undecodable();
    bytes.resize(expected);
    if (!image.GetBuffer(bytes.data())) return undecodable();
  }
  DecodedFrames decoded;
  if (!rescaleAs(type, bytes.data(), header, decoded)) return undecodable();
  return decoded;
}

}  // namespace

Result<DecodedFrames> decodeFrames(const DicomHeader& header)
{
  return header.coding == PixelCoding::compressed ? decodeCompressed(header) : decodePlain(header);
}

}  // namespace perilymph::imaging
