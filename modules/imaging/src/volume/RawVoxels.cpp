// SPDX-License-Identifier: BSD-3-Clause
#include "RawVoxels.h"

#include <fcntl.h>
#include <unistd.h>
#include <zlib.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <memory>

#include "../dicom/DicomFiles.h"

namespace perilymph::imaging {
namespace {

constexpr double maxClippedFraction = 1e-3;
constexpr double minSpan = 100.0;
constexpr std::size_t chunk = std::size_t{1} << 22;

template <class Value, class Bits>
double valueAt(const char* place, bool isBigEndian)
{
  Bits bits = 0;
  for (std::size_t k = 0; k < sizeof(Bits); ++k) {
    const std::size_t at = isBigEndian ? k : sizeof(Bits) - 1 - k;
    bits = static_cast<Bits>((static_cast<std::uint64_t>(bits) << 8) |
                             static_cast<unsigned char>(place[at]));
  }
  return static_cast<double>(std::bit_cast<Value>(bits));
}

using Reader = double (*)(const char*, bool);

Reader readerOf(VoxelType type)
{
  switch (type) {
    case VoxelType::int8:
      return valueAt<std::int8_t, std::uint8_t>;
    case VoxelType::uint8:
      return valueAt<std::uint8_t, std::uint8_t>;
    case VoxelType::int16:
      return valueAt<std::int16_t, std::uint16_t>;
    case VoxelType::uint16:
      return valueAt<std::uint16_t, std::uint16_t>;
    case VoxelType::int32:
      return valueAt<std::int32_t, std::uint32_t>;
    case VoxelType::uint32:
      return valueAt<std::uint32_t, std::uint32_t>;
    case VoxelType::float32:
      return valueAt<float, std::uint32_t>;
    case VoxelType::float64:
      break;
  }
  return valueAt<double, std::uint64_t>;
}

using GzipFile = std::unique_ptr<gzFile_s, int (*)(gzFile)>;

Error unreadable(const std::filesystem::path& file)
{
  return Error{file.string() + " cannot be read. Check its name and permissions."};
}

Error cutOff(const std::filesystem::path& file)
{
  return Error{file.string() + " is cut off or damaged. Copy or export it again."};
}

Result<std::string> readOpen(gzFile_s& open, const std::filesystem::path& file, std::size_t count,
                             const ReadingHooks& hooks)
{
  std::string bytes;
  while (bytes.size() < count) {
    if (hooks.isCanceled && hooks.isCanceled()) return canceledReading();
    const std::size_t before = bytes.size();
    const std::size_t wanted = std::min(chunk, count - before);
    bytes.resize(before + wanted);
    if (gzread(&open, bytes.data() + before, static_cast<unsigned>(wanted)) !=
        static_cast<int>(wanted))
      return cutOff(file);
    if (hooks.onProgress)
      hooks.onProgress(static_cast<double>(bytes.size()) / static_cast<double>(count));
  }
  return bytes;
}

}  // namespace

std::size_t bytesOf(VoxelType type)
{
  switch (type) {
    case VoxelType::int8:
    case VoxelType::uint8:
      return 1;
    case VoxelType::int16:
    case VoxelType::uint16:
      return 2;
    case VoxelType::int32:
    case VoxelType::uint32:
    case VoxelType::float32:
      return 4;
    case VoxelType::float64:
      break;
  }
  return 8;
}

Result<std::string> readBytes(const std::filesystem::path& file, std::size_t from,
                              std::size_t count, const ReadingHooks& hooks)
{
  // zlib reads files that are not packed as they are.
  const GzipFile open(gzopen(file.c_str(), "rb"), gzclose);
  if (!open) return unreadable(file);
  if (gzseek(open.get(), static_cast<z_off_t>(from), SEEK_SET) < 0) return cutOff(file);
  return readOpen(*open, file, count, hooks);
}

Result<std::string> readPackedBytes(const std::filesystem::path& file, std::size_t packedFrom,
                                    std::size_t count, const ReadingHooks& hooks)
{
  const int descriptor = ::open(file.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0) return unreadable(file);
  ::lseek(descriptor, static_cast<off_t>(packedFrom), SEEK_SET);
  const GzipFile open(gzdopen(descriptor, "rb"), gzclose);
  if (!open) {
    ::close(descriptor);
    return unreadable(file);
  }
  if (gzdirect(open.get()) != 0) return cutOff(file);
  return readOpen(*open, file, count, hooks);
}

Result<std::vector<std::int16_t>> toVoxels(const std::string& bytes, VoxelType type,
                                           bool isBigEndian, double slope, double intercept)
{
  constexpr double low = std::numeric_limits<std::int16_t>::min();
  constexpr double high = std::numeric_limits<std::int16_t>::max();
  const std::size_t size = bytesOf(type);
  const Reader read = readerOf(type);
  std::vector<std::int16_t> voxels(bytes.size() / size);
  std::size_t clipped = 0;
  double smallest = std::numeric_limits<double>::infinity(), largest = -smallest;
  for (std::size_t i = 0; i < voxels.size(); ++i) {
    const double value = slope * read(bytes.data() + i * size, isBigEndian) + intercept;
    if (!std::isfinite(value))
      return Error{
          "It holds voxels that are not finite numbers. Export the volume as 16-bit Hounsfield "
          "units."};
    smallest = std::min(smallest, value);
    largest = std::max(largest, value);
    clipped += value < low || value > high ? 1 : 0;
    voxels[i] = static_cast<std::int16_t>(std::clamp(std::round(value), low, high));
  }
  if (static_cast<double>(clipped) > maxClippedFraction * static_cast<double>(voxels.size()))
    return Error{std::to_string(clipped) +
                 " voxels lie beyond -32768 to 32767, which 16 bits hold. Export the volume as "
                 "Hounsfield units."};
  if (!(largest - smallest >= minSpan))
    return Error{
        "Its intensities span less than 100, so they are no Hounsfield units: a mask, a label or a "
        "normalized volume. Export the CT itself."};
  return voxels;
}

}  // namespace perilymph::imaging
