// SPDX-License-Identifier: BSD-3-Clause
#include "Encapsulated.h"

#include <array>
#include <fstream>

namespace perilymph::imaging {
namespace {

/// Whether two bytes are the marker that begins an image: SOI of JPEG and JPEG-LS, SOC of JPEG 2000.
bool beginsAnImage(unsigned char first, unsigned char second)
{
  return first == 0xFF && (second == 0xD8 || second == 0x4F);
}

}  // namespace

std::optional<Fragments> fragmentsOf(const std::filesystem::path& file, std::int64_t start)
{
  // DICOM part 5, A.4: items (FFFE,E000) with their length, then (FFFE,E0DD). The first is the offset table.
  std::error_code failed;
  const auto end = static_cast<std::int64_t>(std::filesystem::file_size(file, failed));
  std::ifstream stream(file, std::ios::binary);
  if (failed || !stream) return std::nullopt;
  Fragments fragments;
  bool isTable = true;
  std::array<unsigned char, 10> tag{};
  for (std::int64_t place = start; place + 8 <= end;) {
    stream.seekg(place);
    if (!stream.read(reinterpret_cast<char*>(tag.data()), 8)) return std::nullopt;
    if (tag[0] != 0xFE || tag[1] != 0xFF || tag[3] != 0xE0) return std::nullopt;
    if (tag[2] == 0xDD) return fragments;
    if (tag[2] != 0x00) return std::nullopt;
    std::int64_t length = 0;
    for (std::size_t k = 8; k-- > 4;) length = (length << 8) | tag[k];
    if (isTable) {
      fragments.offsets = static_cast<std::size_t>(length / 4);
    } else {
      ++fragments.count;
      if (length >= 2 && stream.read(reinterpret_cast<char*>(tag.data()) + 8, 2) &&
          beginsAnImage(tag[8], tag[9]))
        ++fragments.starts;
    }
    isTable = false;
    place += 8 + length;
  }
  return std::nullopt;
}

}  // namespace perilymph::imaging
