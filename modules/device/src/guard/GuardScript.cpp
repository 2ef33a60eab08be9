// SPDX-License-Identifier: BSD-3-Clause
#include "guard/GuardScript.h"

#include <algorithm>

namespace perilymph::device::guard {

namespace {

constexpr std::size_t lineHead = 3;  // kind, size in two bytes

std::size_t number(const std::uint8_t* low) noexcept
{
  return static_cast<std::size_t>(low[0]) | static_cast<std::size_t>(low[1]) << 8;
}

void put(std::uint8_t* low, std::size_t value) noexcept
{
  low[0] = static_cast<std::uint8_t>(value & 0xff);
  low[1] = static_cast<std::uint8_t>(value >> 8 & 0xff);
}

}  // namespace

Script::Script(std::uint8_t patience_ms) noexcept
{
  bytes_[0] = version;
  bytes_[1] = patience_ms;
}

bool Script::add(const Line& line) noexcept
{
  const std::size_t needed = lineHead + line.bytes.size();
  if (line.bytes.empty() || lines() >= maxLines || size_ + needed > capacity) return false;
  std::uint8_t* const place = bytes_.data() + size_;
  place[0] = line.isFeature ? 1 : 0;
  put(place + 1, line.bytes.size());
  std::copy(line.bytes.begin(), line.bytes.end(), place + lineHead);
  size_ += needed;
  put(bytes_.data() + 4, size_ - head);
  return true;
}

bool Script::addNoForce(const Line& line) noexcept
{
  if (bytes_[3] != 0 || !add(line)) return false;
  ++bytes_[2];
  return true;
}

bool Script::addSwitchOff(const Line& line) noexcept
{
  if (!add(line)) return false;
  ++bytes_[3];
  return true;
}

std::size_t Script::sizeBehind(std::span<const std::uint8_t> headBytes) noexcept
{
  if (headBytes.size() < head || headBytes[0] != version) return 0;
  const std::size_t size = number(headBytes.data() + 4);
  return size <= capacity - head ? size : 0;
}

bool Script::take(std::span<const std::uint8_t> bytes) noexcept
{
  const std::size_t behind = sizeBehind(bytes);
  if (behind == 0 || bytes.size() != head + behind) return false;
  std::size_t at = head, found = 0;
  while (at + lineHead <= bytes.size()) {
    const std::size_t size = number(bytes.data() + at + 1);
    if (bytes[at] > 1 || size == 0) return false;  // no kind of report, or an empty one
    at += lineHead + size;
    ++found;
  }
  const std::size_t told = std::size_t{bytes[2]} + bytes[3];
  if (at != bytes.size() || found != told || found > maxLines) return false;
  std::copy(bytes.begin(), bytes.end(), bytes_.begin());
  size_ = bytes.size();
  return true;
}

Line Script::line(std::size_t index) const noexcept
{
  std::size_t at = head;
  for (std::size_t i = 0; i < index; ++i) at += lineHead + number(bytes_.data() + at + 1);
  const std::uint8_t* const place = bytes_.data() + at;
  return {place[0] != 0, {place + lineHead, number(place + 1)}};
}

}  // namespace perilymph::device::guard
