#pragma once

// Words out of other people's files, on a terminal.

#include <string>
#include <string_view>

namespace perilymph::cli {

/// The text with what would steer a terminal or reorder its line written out, byte by byte: an
/// escape becomes "\x1b". Written out are control characters (U+0000 to U+001F, U+007F to U+009F),
/// the controls of bidirectional text, the separators of lines and paragraphs, and every byte that
/// is not UTF-8. Everything else stays as it is.
std::string printable(std::string_view text);

}  // namespace perilymph::cli
