#pragma once

#include <algorithm>
#include <string>

#include "perilymph/foundation/Utf8.h"

namespace perilymph::analysis {

/// A text in quotation marks, as a field of a CSV file (RFC 4180). U+FFFD stands in place of bytes
/// that are not UTF-8.
inline std::string csvQuoted(const std::string& text)
{
  std::string quoted = "\"";
  for (const char letter : validUtf8(text))
    quoted += letter == '"' ? "\"\"" : std::string(1, letter);
  return quoted + "\"";
}

/// The same, with quotation marks only where the text holds a comma, one of them or a control
/// character.
inline std::string csvField(const std::string& text)
{
  const bool needsQuotes = std::any_of(text.begin(), text.end(), [](unsigned char letter) {
    return letter < 0x20 || letter == ',' || letter == '"';
  });
  return needsQuotes ? csvQuoted(text) : validUtf8(text);
}

}  // namespace perilymph::analysis
