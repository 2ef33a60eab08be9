// SPDX-License-Identifier: BSD-3-Clause
#include "RawVoxels.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <string>

namespace perilymph::imaging {
namespace {

constexpr double maxClippedFraction = 1e-3;
constexpr double minSpan = 100.0;

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

void VoxelConverter::add(const char* bytes, std::size_t count, std::int16_t* to)
{
  constexpr double low = std::numeric_limits<std::int16_t>::min();
  constexpr double high = std::numeric_limits<std::int16_t>::max();
  const std::size_t size = bytesOf(coding_.type);
  const Reader read = readerOf(coding_.type);
  for (std::size_t i = 0; i < count; ++i) {
    const double value =
        coding_.slope * read(bytes + i * size, coding_.isBigEndian) + coding_.intercept;
    if (!std::isfinite(value)) {
      isFinite_ = false;
      return;
    }
    smallest_ = std::min(smallest_, value);
    largest_ = std::max(largest_, value);
    clipped_ += value < low || value > high ? 1 : 0;
    if (to) to[i] = static_cast<std::int16_t>(std::clamp(std::round(value), low, high));
  }
  count_ += count;
}

bool VoxelConverter::spansEnough() const noexcept { return largest_ - smallest_ >= minSpan; }

Result<void> VoxelConverter::check() const
{
  if (!isFinite_)
    return Error{
        "It holds voxels that are not finite numbers. Export the volume as 16-bit Hounsfield "
        "units."};
  if (static_cast<double>(clipped_) > maxClippedFraction * static_cast<double>(count_))
    return Error{
        "%1 voxels lie beyond -32768 to 32767, which 16 bits hold. Export the volume as Hounsfield "
        "units.",
        clipped_};
  if (!spansEnough())
    return Error{
        "Its intensities span less than 100, so they are no Hounsfield units: a mask, a label or a "
        "normalized volume. Export the CT itself."};
  return {};
}

}  // namespace perilymph::imaging
