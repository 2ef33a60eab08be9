// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The keys of text files, with what the program says of them: an example of each file has every key,
// and the messages about a changed value or an absent key state what is allowed.

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "perilymph/foundation/FieldMeaning.h"

namespace perilymph::test {

/// One kind of file.
struct KeyedFile {
  const FieldMeanings* meanings;
  /// Keys, "table.key", and their values as TOML: a valid file with every key, or several.
  std::vector<std::vector<std::pair<std::string, std::string>>> examples;
  /// The message about a text that cannot be read; empty if it can.
  std::function<std::string(const std::string& text)> problemOf;
};

KeyedFile scenarioFile();
KeyedFile patientFile();
KeyedFile arrayFile();

/// The keys that the program knows in the file, by its message about an unknown key in each table.
std::vector<std::string> knownKeys(const KeyedFile& file);

/// What the program allows: "a number, between 0 and 5"; "text" for text without a rule.
std::string allowedOf(const KeyedFile& file, const std::string& key);

/// Whether a file without this key is refused for it.
bool isRequired(const KeyedFile& file, const std::string& key);

/// The value that a scenario without keys has, as TOML; empty if it has none.
std::string scenarioDefault(const std::string& key);

}  // namespace perilymph::test
