// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Checks of TOML text before parsing, and formatting of values.

#include <toml++/toml.h>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace perilymph::tomltext {

/// The line (from 1) of the first byte that is not UTF-8.
std::optional<int> lineNotUtf8(std::string_view text);

/// The line (from 1) of the first key with more than 16 parts (`a.b.c`): deeply nested tables would
/// exhaust the parser's stack.
std::optional<int> lineNestedTooDeep(std::string_view text);

/// The shortest text that reads back as the same number, in any locale: "0.1", "1e-09", "22".
std::string shortest(double value);

/// The same as a TOML float, always distinct from an integer: "22.0".
std::string tomlNumber(double value);

/// A value for messages, on one line and at most 60 characters long.
std::string shown(const toml::node& node);
std::string shown(std::string_view text);

/// Words separated by commas.
std::string listed(const std::vector<std::string>& words);

/// A table as TOML, keys sorted: its values first, then its tables.
std::string written(const toml::table& table);

}  // namespace perilymph::tomltext
