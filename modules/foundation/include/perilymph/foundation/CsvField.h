// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Text as a field of a CSV file.

#include <algorithm>
#include <string>

#include "perilymph/foundation/Utf8.h"

namespace perilymph {

/// A text in quotation marks, as a field of a CSV file (RFC 4180). Invalid UTF-8 bytes are replaced
/// by U+FFFD.
inline std::string csvQuoted(const std::string& text)
{
  std::string quoted = "\"";
  for (const char letter : validUtf8(text))
    quoted += letter == '"' ? "\"\"" : std::string(1, letter);
  return quoted + "\"";
}

/// The same, with quotation marks only if the text contains a comma, a quotation mark or a control
/// character.
inline std::string csvField(const std::string& text)
{
  const bool needsQuotes = std::any_of(text.begin(), text.end(), [](unsigned char letter) {
    return letter < 0x20 || letter == ',' || letter == '"';
  });
  return needsQuotes ? csvQuoted(text) : validUtf8(text);
}

}  // namespace perilymph
