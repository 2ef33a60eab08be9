#pragma once

// UTF-8 text from files, devices and other programs, which may hold anything.

#include <cstddef>
#include <string>
#include <string_view>

namespace perilymph {

/// The character at the front of a text.
struct Utf8Character {
  char32_t code = 0;
  std::size_t length = 0;  ///< Bytes; 0 where the first byte begins no valid character.
};

/// Reads the first character of a text that is not empty. Overlong forms, surrogates and code
/// points above U+10FFFF are not valid.
Utf8Character firstCharacter(std::string_view text);

/// The text with U+FFFD in place of every byte that belongs to no valid character: what JSON and
/// CSV may hold.
std::string validUtf8(std::string_view text);

/// The same on one line: a space in place of every control character. For titles and comments in
/// files, and for XML, which has no control characters.
std::string onOneLine(std::string_view text);

}  // namespace perilymph
