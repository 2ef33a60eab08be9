#pragma once

// Words out of other people's files, on a terminal.

#include <string>

namespace perilymph::cli {

/// The text with what would steer a terminal written out: an escape becomes "\x1b". UTF-8 beyond
/// the control characters stays as it is.
std::string printable(const std::string& text);

}  // namespace perilymph::cli
