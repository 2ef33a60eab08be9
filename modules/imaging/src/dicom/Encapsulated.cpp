// SPDX-License-Identifier: BSD-3-Clause
#include "Encapsulated.h"

#include <array>
#include <fstream>

namespace perilymph::imaging {

bool hasAllFragments(const std::filesystem::path& file, std::int64_t start)
{
  // DICOM part 5, A.4: items (FFFE,E000) with their length, then (FFFE,E0DD).
  std::error_code failed;
  const auto end = static_cast<std::int64_t>(std::filesystem::file_size(file, failed));
  std::ifstream stream(file, std::ios::binary);
  if (failed || !stream) return false;
  std::array<unsigned char, 8> tag{};
  for (std::int64_t place = start; place + 8 <= end;) {
    stream.seekg(place);
    if (!stream.read(reinterpret_cast<char*>(tag.data()), 8)) return false;
    if (tag[0] != 0xFE || tag[1] != 0xFF || tag[3] != 0xE0) return false;
    if (tag[2] == 0xDD) return true;
    if (tag[2] != 0x00) return false;
    std::int64_t length = 0;
    for (std::size_t k = 8; k-- > 4;) length = (length << 8) | tag[k];
    place += 8 + length;
  }
  return false;
}

}  // namespace perilymph::imaging
