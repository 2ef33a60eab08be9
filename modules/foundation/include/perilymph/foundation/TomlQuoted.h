// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Text as a value of a TOML file.

#include <string>
#include <string_view>

namespace perilymph {

/// The text as a TOML string on one line, with its quotation marks; control characters as "\u0009".
std::string tomlQuoted(std::string_view text);

}  // namespace perilymph
