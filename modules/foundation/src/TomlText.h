#pragma once

// What comes before and after reading TOML: is the text safe to parse, and how values are written.

#include <toml++/toml.h>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace perilymph::tomltext {

/// The line (from 1) of the first byte that is not UTF-8.
std::optional<int> lineNotUtf8(std::string_view text);

/// The line (from 1) of the first key with more than 16 parts (`a.b.c`): tables nested without
/// bound would exhaust the stack of the parser.
std::optional<int> lineNestedTooDeep(std::string_view text);

/// The shortest text that reads back as the same number, whatever the locale: "0.1", "1e-09", "22".
std::string shortest(double value);

/// The same as a TOML float, which never looks like an integer: "22.0".
std::string tomlNumber(double value);

/// A value as it is shown to people in a sentence, on one line and at most 60 characters long.
std::string shown(const toml::node& node);
std::string shown(std::string_view text);

/// Words with commas between them.
std::string listed(const std::vector<std::string>& words);

/// A table as TOML, keys sorted: its own values first, then its tables.
std::string written(const toml::table& table);

}  // namespace perilymph::tomltext
