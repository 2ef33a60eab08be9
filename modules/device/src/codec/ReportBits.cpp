// SPDX-License-Identifier: BSD-3-Clause
#include "codec/ReportBits.h"

#include <algorithm>

namespace perilymph::device {

namespace {

constexpr std::uint32_t maxBits = 32;

std::uint32_t usedBits(const ReportSlot& slot) noexcept { return std::min(slot.bits, maxBits); }

}  // namespace

std::int64_t numberAt(std::span<const std::uint8_t> report, const ReportSlot& slot) noexcept
{
  const std::uint32_t bits = usedBits(slot);
  if (bits == 0) return 0;

  // 32 bits at an arbitrary offset span at most five bytes.
  const std::size_t first = slot.bitOffset / 8;
  const std::uint32_t shift = slot.bitOffset % 8;
  std::uint64_t window = 0;
  for (std::size_t i = 0; i < 5; ++i)
    if (first + i < report.size()) window |= std::uint64_t{report[first + i]} << (8 * i);

  const std::uint64_t mask = (std::uint64_t{1} << bits) - 1;
  const std::uint64_t raw = (window >> shift) & mask;
  const bool isNegative = slot.isSigned && (raw >> (bits - 1)) != 0;
  return static_cast<std::int64_t>(isNegative ? raw | ~mask : raw);
}

void putNumber(std::span<std::uint8_t> report, const ReportSlot& slot, std::int64_t number) noexcept
{
  const std::uint32_t bits = usedBits(slot);
  if (bits == 0) return;

  // range of the bits
  const std::int64_t half = std::int64_t{1} << (bits - 1);
  const std::int64_t low = slot.isSigned ? -half : 0;
  const std::int64_t high = slot.isSigned ? half - 1 : 2 * half - 1;
  const auto held = static_cast<std::uint64_t>(std::clamp(number, low, high));

  const std::size_t first = slot.bitOffset / 8;
  const std::uint32_t shift = slot.bitOffset % 8;
  const std::uint64_t mask = ((std::uint64_t{1} << bits) - 1) << shift;
  const std::uint64_t window = (held << shift) & mask;
  for (std::size_t i = 0; i < 5 && first + i < report.size(); ++i) {
    const auto keep = static_cast<std::uint8_t>(~(mask >> (8 * i)) & 0xffu);
    const auto take = static_cast<std::uint8_t>((window >> (8 * i)) & 0xffu);
    report[first + i] = static_cast<std::uint8_t>((report[first + i] & keep) | take);
  }
}

}  // namespace perilymph::device
