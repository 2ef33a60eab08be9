// SPDX-License-Identifier: BSD-3-Clause
#include "Printable.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <utility>

#include "perilymph/foundation/Utf8.h"

namespace perilymph::cli {

namespace {

/// True for control characters: Unicode's category Cc, its property Bidi_Control, and the
/// separators of lines and paragraphs (Unicode 15, PropList.txt and UnicodeData.txt).
bool steers(char32_t code)
{
  constexpr std::array<std::pair<char32_t, char32_t>, 7> ranges = {{{0x00, 0x1f},
                                                                    {0x7f, 0x9f},
                                                                    {0x61c, 0x61c},
                                                                    {0x200e, 0x200f},
                                                                    {0x2028, 0x202e},
                                                                    {0x2066, 0x2069},
                                                                    {0xfeff, 0xfeff}}};
  return std::any_of(ranges.begin(), ranges.end(), [code](const auto& range) {
    return code >= range.first && code <= range.second;
  });
}

}  // namespace

std::string printable(std::string_view text)
{
  std::string shown;
  while (!text.empty()) {
    const Utf8Character first = firstCharacter(text);
    const std::string_view bytes = text.substr(0, first.length == 0 ? 1 : first.length);
    text.remove_prefix(bytes.size());
    if (first.length != 0 && !steers(first.code)) {
      shown += bytes;
      continue;
    }
    for (const char byte : bytes) {
      char digits[5];
      std::snprintf(digits, sizeof digits, "\\x%02x",
                    static_cast<unsigned>(static_cast<unsigned char>(byte)));
      shown += digits;
    }
  }
  return shown;
}

}  // namespace perilymph::cli
