// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The data of a TomlReader for one table: values, requested keys, first error.

#include <toml++/toml.h>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "Suggestion.h"
#include "TomlText.h"
#include "perilymph/foundation/RenamedKeys.h"
#include "perilymph/foundation/TomlReader.h"

namespace perilymph {

/// One table, its requested keys and its first error.
struct TomlReader::Content {
  struct KeptError {
    std::string sentence;
    std::string missingKey;  ///< The missing key; empty for other errors.
  };

  std::string name;
  std::string path;  ///< Path of this table in the file, such as "stylet."; empty for the file.
  int line = 0;      ///< Line where the table starts; 0 for the file itself.
  toml::table table;
  std::set<std::string, std::less<>> asked;
  std::map<std::string, std::string, std::less<>> changed;  ///< Values given to set().
  std::optional<KeptError> error;
  std::vector<std::shared_ptr<Content>> inner;
  std::vector<RenamedKeyUse> renamed;  ///< Keys with an old name, also in inner tables.

  /// The node of a key; marks the key as requested.
  const toml::node* ask(std::string_view key)
  {
    asked.emplace(key);
    return table.get(key);
  }

  /// Place of a key, to begin a message: "my.toml:7: ".
  std::string place(std::string_view key) const
  {
    const auto change = changed.find(key);
    if (change != changed.end())
      return "--set " + path + std::string(key) + "=" + tomltext::shown(change->second) + ": ";
    const int keyLine = lineOf(key);
    return placeOfLine(keyLine != 0 ? keyLine : line);
  }

  /// The line of a key; 0 if it is absent or did not come from the file.
  int lineOf(std::string_view key) const
  {
    const auto entry = table.find(key);
    return entry != table.end() ? static_cast<int>(entry->first.source().begin.line) : 0;
  }

  std::string placeOfLine(int number) const
  {
    return name + (number != 0 ? ":" + std::to_string(number) : "") + ": ";
  }

  void keep(std::string sentence)
  {
    if (!error) error = KeptError{std::move(sentence), ""};
  }

  void keepMissing(std::string_view key, const std::string& mustBe)
  {
    if (error) return;
    error = KeptError{placeOfLine(line) + "key '" + path + std::string(key) +
                          "' is missing; it must be " + mustBe + ".",
                      std::string(key)};
  }

  void keepInvalid(std::string_view key, const toml::node& node, const std::string& mustBe)
  {
    keep(place(key) + path + std::string(key) + " is " + tomltext::shown(node) + "; it must be " +
         mustBe + ".");
  }

  /// The keys of the file that were never requested.
  std::vector<std::string> unknownKeys() const
  {
    std::vector<std::string> unknown;
    for (const auto& [key, value] : table)
      if (asked.count(key.str()) == 0) unknown.emplace_back(key.str());
    return unknown;
  }

  std::string unknownKey(const std::string& key) const
  {
    const std::string meant = nearestWord(key, {asked.begin(), asked.end()});
    std::string sentence = place(key) + "unknown key '" + path + tomltext::shown(key) + "'; ";
    if (!meant.empty()) return sentence + "did you mean " + path + meant + "?";
    if (asked.empty()) return sentence + "no keys are known here.";
    return sentence + "known are " + tomltext::listed({asked.begin(), asked.end()}) + ".";
  }

  /// The first error in this table and its inner tables; empty if there is none.
  std::string firstError() const
  {
    const std::vector<std::string> unknown = unknownKeys();

    // A misspelled key explains why the correct one is missing: report the misspelling.
    if (error && !error->missingKey.empty())
      for (const std::string& key : unknown)
        if (!nearestWord(key, {error->missingKey}).empty()) return unknownKey(key);

    if (error) return error->sentence;
    for (const auto& content : inner) {
      const std::string sentence = content->firstError();
      if (!sentence.empty()) return sentence;
    }
    return unknown.empty() ? std::string() : unknownKey(unknown.front());
  }

  /// An inner table with its own errors, included in firstError() of this one. Requesting it twice
  /// returns the same object.
  std::shared_ptr<Content> addInner(const toml::table& innerTable, const std::string& innerPath,
                                    std::string_view key)
  {
    const std::string whole = path + innerPath + ".";
    for (const auto& known : inner)
      if (known->path == whole) return known;
    auto content = std::make_shared<Content>();
    content->name = name;
    content->path = whole;
    content->table = innerTable;
    content->line = static_cast<int>(innerTable.source().begin.line);
    const std::string prefix = std::string(key) + ".";
    for (const auto& [name_, value] : changed)
      if (name_.compare(0, prefix.size(), prefix) == 0)
        content->changed[name_.substr(prefix.size())] = value;
    inner.push_back(content);
    return content;
  }
};

}  // namespace perilymph
