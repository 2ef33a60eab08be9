// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Untrusted UTF-8 text from files, devices and other programs.

#include <cstddef>
#include <string>
#include <string_view>

namespace perilymph {

/// The first character of a text.
struct Utf8Character {
  char32_t code = 0;
  std::size_t length = 0;  ///< Bytes; 0 if the first byte begins no valid character.
};

/// Reads the first character of a nonempty text. Overlong forms, surrogates and code points above
/// U+10FFFF are invalid.
Utf8Character firstCharacter(std::string_view text);

/// The text with U+FFFD in place of every byte that belongs to no valid character (JSON, CSV).
std::string validUtf8(std::string_view text);

/// The same with every control character replaced by a space. For titles and comments in files, and
/// for XML, which allows no control characters.
std::string onOneLine(std::string_view text);

}  // namespace perilymph
