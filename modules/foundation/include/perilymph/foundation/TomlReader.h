// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Reads the TOML files of users (scenarios, patients, arrays, devices) and reports an error in
// one sentence: file, line, key, value, range.

#include <array>
#include <cstddef>
#include <filesystem>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "perilymph/foundation/Choice.h"
#include "perilymph/foundation/Result.h"

namespace perilymph {

/// Allowed values of a number, limits included. The unit is part of the key's name.
struct Range {
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
};

/// One table of a TOML file being read. Every key is requested by name; finish() refuses keys that
/// were never requested. The first error is kept and later calls return fallbacks, so that a caller
/// requests all its keys in a row and checks finish() once.
///
/// Keys of physical values end with their unit (`length_mm`).
class TomlReader {
public:
  /// Opens a file, which must be well-formed TOML of at most 16 MiB. Keys with an old name
  /// (RenamedKeys.h) are read under the new one, with a warning.
  static Result<TomlReader> open(const std::filesystem::path& file);
  /// The same for text from another source, without warnings; messages show `name` in place of the
  /// file.
  static Result<TomlReader> parse(std::string_view text, std::string name);

  TomlReader(TomlReader&&) noexcept;
  TomlReader& operator=(TomlReader&&) noexcept;
  ~TomlReader();

  bool has(std::string_view key) const;

  /// A finite number within the range; a missing key is an error.
  double number(std::string_view key, Range allowed);
  /// A finite number within the range, or the fallback when the key is absent.
  double number(std::string_view key, Range allowed, double fallback);
  /// A whole number within the range, or the fallback when the key is absent.
  long integer(std::string_view key, long low, long high, long fallback);
  bool flag(std::string_view key, bool fallback);
  /// Text; a missing key is an error.
  std::string text(std::string_view key);
  std::string text(std::string_view key, std::string fallback);
  /// Text that must be one of the choices; a missing key is an error unless a fallback is given.
  std::string choice(std::string_view key, const std::vector<std::string>& choices,
                     std::optional<std::string> fallback = std::nullopt);
  /// The same as a value of a table of choices.
  template <class Value, std::size_t count>
  Value choice(std::string_view key, const std::array<Choice<Value>, count>& table,
               std::optional<std::type_identity_t<Value>> fallback = std::nullopt)
  {
    std::vector<std::string> choices;
    for (const Choice<Value>& row : table) choices.emplace_back(row.name);
    const std::string text = fallback ? choice(key, choices, std::string(nameIn(table, *fallback)))
                                      : choice(key, choices);
    return valueIn(table, text).value_or(table[0].value);  // what was refused is kept as an error
  }
  /// A list of finite numbers, each within the range, of at least `fewest` entries.
  std::vector<double> numbers(std::string_view key, Range allowed, std::size_t fewest);

  /// The keys of this table, sorted, for a table whose keys are the user's choice.
  std::vector<std::string> keys() const;
  /// A list of at least one number, text, true or false, each as it would follow `--set key=`.
  std::vector<std::string> values(std::string_view key);
  /// One such value.
  std::string value(std::string_view key);

  /// The tables of `[[key]]`, each to be read and finished separately; empty if absent.
  std::vector<TomlReader> tables(std::string_view key);
  /// The table `[key]`; an empty one if absent.
  TomlReader table(std::string_view key);

  /// Records an error found by the caller, at the line of `key`, unless there is one already.
  void refuse(std::string_view key, const std::string& sentence);

  /// Changes or adds one value before it is read: `--set key=value` of the command line. A value
  /// that is not TOML ("2.0", "true") is taken as text.
  void set(const std::string& given, const std::string& value);

  /// Removes a value of this table before it is read.
  void remove(std::string_view key);

  /// Success, or the first error in this table and its child tables; unknown keys are errors.
  Result<void> finish();

  /// The file, or the name given to parse().
  const std::string& name() const;
  /// The table as TOML text, keys sorted, as recordings store a scenario.
  std::string dump() const;

private:
  struct Content;
  explicit TomlReader(std::shared_ptr<Content> content);

  // Shared with the reader of the enclosing table, whose finish() checks both.
  std::shared_ptr<Content> content_;
};

}  // namespace perilymph
