// SPDX-License-Identifier: BSD-3-Clause
#include "SequenceDepth.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <fstream>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace perilymph::imaging {
namespace {

constexpr std::uint32_t itemStart = 0xFFFEE000, itemEnd = 0xFFFEE00D, sequenceEnd = 0xFFFEE0DD,
                        pixelData = 0x7FE00010, undefinedLength = 0xFFFFFFFF;
constexpr std::size_t windowBytes = 8192;

/// Bytes of a file at any place, through one window.
class Window {
public:
  explicit Window(const std::filesystem::path& file) : stream_(file, std::ios::binary) {}

  /// `count` bytes at a place; empty beyond the end of the file.
  std::span<const unsigned char> at(std::int64_t place, std::size_t count)
  {
    if (place < start_ || place + static_cast<std::int64_t>(count) > start_ + filled_) load(place);
    if (place + static_cast<std::int64_t>(count) > start_ + filled_) return {};
    return {bytes_.data() + (place - start_), count};
  }

private:
  void load(std::int64_t place)
  {
    stream_.clear();
    stream_.seekg(place);
    stream_.read(reinterpret_cast<char*>(bytes_.data()), windowBytes);
    start_ = place;
    filled_ = std::max<std::int64_t>(stream_.gcount(), 0);
  }

  std::ifstream stream_;
  std::array<unsigned char, windowBytes> bytes_{};
  std::int64_t start_ = 0, filled_ = 0;
};

/// Head of an element, as far as it matters here.
struct Head {
  std::uint32_t tag = 0, length = 0;
  std::int64_t value = 0;  ///< Byte at which the value begins.
  bool isSequence = false;
};

std::uint32_t number(std::span<const unsigned char> bytes, bool isBigEndian)
{
  std::uint32_t value = 0;
  for (std::size_t k = 0; k < bytes.size(); ++k)
    value = value << 8 | bytes[isBigEndian ? k : bytes.size() - 1 - k];
  return value;
}

std::uint32_t tagIn(std::span<const unsigned char> bytes, bool isBigEndian)
{
  return number(bytes.first(2), isBigEndian) << 16 | number(bytes.subspan(2, 2), isBigEndian);
}

std::optional<Head> headAt(Window& window, std::int64_t place, bool isBigEndian)
{
  const auto start = window.at(place, 8);
  if (start.empty()) return std::nullopt;
  Head head;
  head.tag = tagIn(start, isBigEndian);
  const auto isLetter = [](unsigned char c) { return c >= 'A' && c <= 'Z'; };
  if (head.tag >> 16 == 0xFFFE || !isLetter(start[4]) || !isLetter(start[5])) {
    head.length = number(start.subspan(4, 4), isBigEndian);
    head.value = place + 8;
  } else {
    const std::string_view type(reinterpret_cast<const char*>(start.data()) + 4, 2);
    head.isSequence = type == "SQ";
    const bool isLong = type == "OB" || type == "OD" || type == "OF" || type == "OL" ||
                        type == "OV" || type == "OW" || type == "SQ" || type == "SV" ||
                        type == "UC" || type == "UN" || type == "UR" || type == "UT" ||
                        type == "UV";
    const auto length = isLong ? window.at(place + 8, 4) : window.at(place + 6, 2);
    if (length.empty()) return std::nullopt;
    head.length = number(length, isBigEndian);
    head.value = place + (isLong ? 12 : 8);
  }
  if (head.length == undefinedLength) head.isSequence = true;
  // without a stated representation, a sequence is told by its first item
  if (!head.isSequence && head.length >= 8)
    if (const auto first = window.at(head.value, 4); !first.empty())
      head.isSequence = tagIn(first, isBigEndian) == itemStart;
  return head;
}

/// What an element stands in: a sequence or one of its items.
struct Open {
  bool isSequence;
  std::int64_t end;  ///< Byte behind it; -1 where it ends with a delimiter.
};

}  // namespace

bool isNestedTooDeep(const std::filesystem::path& file)
{
  Window window(file);
  const auto magic = window.at(128, 4);
  const bool hasPreamble = !magic.empty() && std::equal(magic.begin(), magic.end(), "DICM");
  std::int64_t place = hasPreamble ? 132 : 0;
  const auto start = window.at(place, 8);
  if (start.empty() || (!hasPreamble && !((start[0] == 2 || start[0] == 8) && start[1] == 0)))
    return false;
  bool isBigEndian = false, isOrderKnown = false;
  std::vector<Open> open;
  int depth = 0;
  const auto close = [&] {
    depth -= open.back().isSequence ? 1 : 0;
    open.pop_back();
  };
  while (true) {
    while (!open.empty() && open.back().end >= 0 && place >= open.back().end) close();
    const auto head = headAt(window, place, isBigEndian);
    if (!head) return false;
    // behind the meta information, the first group is below 256 in the right order of bytes
    if (const std::uint32_t group = head->tag >> 16; !isOrderKnown && group != 0x2) {
      isOrderKnown = true;
      isBigEndian = group > 0xFF;
      if (isBigEndian) continue;
    }
    place = head->value;
    if (head->tag == itemEnd || head->tag == sequenceEnd) {
      if (!open.empty()) close();
    } else if (head->tag == itemStart) {
      open.push_back({false, head->length == undefinedLength ? -1 : place + head->length});
    } else if (head->tag == pixelData && open.empty()) {
      return false;
    } else if (head->isSequence) {
      if (++depth > maxSequenceDepth) return true;
      open.push_back({true, head->length == undefinedLength ? -1 : place + head->length});
    } else {
      place += head->length;
    }
  }
}

}  // namespace perilymph::imaging
