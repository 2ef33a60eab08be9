// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Escaping of untrusted text for a terminal.

#include <string>
#include <string_view>

namespace perilymph::cli {

/// The text with everything that could control a terminal or reorder its line escaped byte by byte:
/// an escape character becomes "\x1b". Escaped are control characters (U+0000 to U+001F, U+007F to
/// U+009F), the controls of bidirectional text, the separators of lines and paragraphs, and every
/// byte that is not UTF-8. All other text is unchanged.
std::string printable(std::string_view text);

}  // namespace perilymph::cli
