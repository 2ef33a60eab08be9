// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Writes a scenario as run: every value, in the units of its file, so that reading the text gives
// the same bits.

#include <array>
#include <string>
#include <utility>
#include <vector>

#include "perilymph/anatomy/AnatomySource.h"
#include "perilymph/foundation/TomlReader.h"
#include "perilymph/session/ScenarioChoices.h"

namespace perilymph::session {

/// The shortest decimal that reads back as the same number, as a TOML float ("2.0").
std::string tomlNumber(double value);

/// Numbers as a TOML array.
std::string tomlNumbers(const std::vector<double>& values);

/// "one, two, three"
std::string joined(const std::vector<std::string>& names);

/// The shortest number that millimeters() converts to exactly this length.
double exactMillimeters(Length length);

/// Reads keys from a scenario's file and records each value as read.
class ScenarioKeys {
public:
  explicit ScenarioKeys(TomlReader& reader) : reader_(reader) {}

  double number(const char* key, Range allowed, double fallback);
  long integer(const char* key, long low, long high, long fallback);
  bool flag(const char* key, bool fallback);
  std::string text(const char* key, const std::string& fallback);
  /// A value by its name in a table of choices.
  template <class Value, std::size_t count>
  Value choice(const char* key, const std::array<Choice<Value>, count>& table, Value fallback)
  {
    const std::string name = text(key, nameIn(table, fallback));
    if (const auto value = valueIn(table, name)) return *value;
    std::vector<std::string> allowed;
    for (const Choice<Value>& row : table)
      allowed.push_back((count == 2 ? "'" + std::string(row.name) + "'" : row.name) +
                        (row.meaning ? " (" + std::string(row.meaning) + ")" : ""));
    refuseChoice(key, name, allowed);
    return fallback;
  }

  /// Adds a value without a key of the same name.
  void note(const std::string& key, const std::string& toml) { values_.emplace_back(key, toml); }
  /// Adds the numbers that an anatomy is built from, as a table.
  void notePatient(const anatomy::Patient& patient, anatomy::AnatomySource anatomy);

  /// Keys and values in order; keys in a table are prefixed with its name: "table.key".
  const std::vector<std::pair<std::string, std::string>>& values() const { return values_; }
  /// The same as TOML.
  std::string asToml() const;

private:
  void refuseChoice(const char* key, const std::string& name,
                    const std::vector<std::string>& allowed);

  TomlReader& reader_;
  std::vector<std::pair<std::string, std::string>> values_;
};

}  // namespace perilymph::session
