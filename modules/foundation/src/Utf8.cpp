// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/foundation/Utf8.h"

namespace perilymph {
namespace {

constexpr std::string_view replacement = "\xef\xbf\xbd";  // U+FFFD

bool isControl(char32_t code) { return code < 0x20 || (code >= 0x7f && code < 0xa0); }

/// Calls `each` with the bytes of every character, and with U+FFFD for every invalid byte.
template <class Each>
void forEachCharacter(std::string_view text, const Each& each)
{
  while (!text.empty()) {
    const Utf8Character first = firstCharacter(text);
    if (first.length == 0)
      each(char32_t{0xfffd}, replacement);
    else
      each(first.code, text.substr(0, first.length));
    text.remove_prefix(first.length == 0 ? 1 : first.length);
  }
}

}  // namespace

Utf8Character firstCharacter(std::string_view text)
{
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned char first = byte(0);
  if (first < 0x80) return {first, 1};
  const std::size_t length = first >= 0xf0 ? 4 : first >= 0xe0 ? 3 : 2;
  if (first < 0xc2 || first > 0xf4 || text.size() < length) return {};
  char32_t code = first & (0x7fu >> length);
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(i) & 0xc0) != 0x80) return {};
    code = code << 6 | (byte(i) & 0x3fu);
  }
  const bool isOverlong = (length == 3 && code < 0x800) || (length == 4 && code < 0x10000);
  const bool isSurrogate = code >= 0xd800 && code < 0xe000;
  if (isOverlong || isSurrogate || code > 0x10ffff) return {};
  return {code, length};
}

std::string validUtf8(std::string_view text)
{
  std::string valid;
  forEachCharacter(text, [&](char32_t, std::string_view bytes) { valid += bytes; });
  return valid;
}

std::string onOneLine(std::string_view text)
{
  std::string line;
  forEachCharacter(text, [&](char32_t code, std::string_view bytes) {
    line += isControl(code) ? std::string_view(" ") : bytes;
  });
  return line;
}

}  // namespace perilymph
