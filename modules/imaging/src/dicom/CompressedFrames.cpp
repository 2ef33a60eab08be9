// SPDX-License-Identifier: BSD-3-Clause
#include "CompressedFrames.h"

#include <gdcmImage.h>
#include <gdcmImageReader.h>

#include <cstddef>
#include <optional>
#include <stop_token>

#include "../SharedMemory.h"
#include "../UntrustedRead.h"

namespace perilymph::imaging {
namespace {

std::optional<StoredType> typeOf(const gdcm::PixelFormat& format)
{
  const bool isSigned = format.GetPixelRepresentation() == 1;
  switch (format.GetBitsAllocated()) {
    case 8:
      return isSigned ? StoredType::int8 : StoredType::uint8;
    case 16:
      return isSigned ? StoredType::int16 : StoredType::uint16;
    case 32:
      return isSigned ? StoredType::int32 : StoredType::uint32;
    default:
      return std::nullopt;
  }
}

/// Type of the values in `bytes` after decoding; none where the file is not what its header says.
std::optional<StoredType> decodeInto(const DicomHeader& header, std::span<std::byte> bytes)
{
  gdcm::ImageReader reader;
  reader.SetFileName(header.file.c_str());
  if (!reader.Read()) return std::nullopt;
  const gdcm::Image& image = reader.GetImage();
  if (image.GetPixelFormat().GetSamplesPerPixel() != 1 || image.GetBufferLength() != bytes.size() ||
      image.GetPixelFormat().GetBitsAllocated() != header.bitsAllocated ||
      image.GetNumberOfDimensions() < 2 ||
      image.GetDimension(0) != static_cast<unsigned>(header.columns) ||
      image.GetDimension(1) != static_cast<unsigned>(header.rows) ||
      !image.GetBuffer(reinterpret_cast<char*>(bytes.data())))
    return std::nullopt;
  return typeOf(image.GetPixelFormat());
}

}  // namespace

bool decodeCompressed(const DicomHeader& header, const std::stop_token& stop,
                      const std::function<void(StoredType, std::span<const std::byte>)>& use)
{
  const std::size_t size = static_cast<std::size_t>(header.rows) *
                           static_cast<std::size_t>(header.columns) * header.frames.size() *
                           (static_cast<std::size_t>(header.bitsAllocated) / 8);
  if (size == 0 || size > 4 * maxDecodedVoxels) return false;
  const SharedMemory memory(size);
  if (!memory.isThere()) return false;
  const std::span<std::byte> bytes(memory.start(), size);
  const auto decode = [&] {
    const auto type = decodeInto(header, bytes);
    return type ? static_cast<int>(*type) : childFailed;
  };
  const int status = runInChild(decode, {std::nullopt, stop, {}});
  if (status >= childFailed) return false;
  use(static_cast<StoredType>(status), bytes);
  return true;
}

}  // namespace perilymph::imaging
