// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// What files choose by name: one table for each enumeration. A text that is no name of a table has no
// value: no reader compares a text with one name and takes every other text for the rest.

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>

namespace perilymph {

/// Row of a table of choices.
template <class Value>
struct Choice {
  Value value;
  const char* name;               ///< In files and on the command line.
  const char* meaning = nullptr;  ///< Follows the name in a refusal.
};

/// Name of a value in its table.
template <class Value, std::size_t count>
constexpr const char* nameIn(const std::array<Choice<Value>, count>& table, Value value)
{
  for (const Choice<Value>& row : table)
    if (row.value == value) return row.name;
  return "";
}

/// Value of a name in a table; nothing if it has none of this name.
template <class Value, std::size_t count>
constexpr std::optional<Value> valueIn(const std::array<Choice<Value>, count>& table,
                                       std::string_view name)
{
  for (const Choice<Value>& row : table)
    if (name == row.name) return row.value;
  return std::nullopt;
}

}  // namespace perilymph
