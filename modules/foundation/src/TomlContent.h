#pragma once

// What a TomlReader keeps of one table: its values, what was asked of it, the first mistake.

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

/// One table, what was asked of it and the first mistake in it.
struct TomlReader::Content {
  struct KeptError {
    std::string sentence;
    std::string missingKey;  ///< The key whose absence it is; empty for others.
  };

  std::string name;
  std::string path;  ///< Path of this table in the file, such as "stylet."; empty for the file.
  int line = 0;      ///< Where the table starts; 0 for the file itself.
  toml::table table;
  std::set<std::string, std::less<>> asked;
  std::map<std::string, std::string, std::less<>>
      changed;  ///< By set(): the value as it was given.
  std::optional<KeptError> error;
  std::vector<std::shared_ptr<Content>> inner;
  std::vector<RenamedKeyUse> renamed;  ///< Keys given under their old names, inner tables' too.

  /// The node of a key, which counts as asked for.
  const toml::node* ask(std::string_view key)
  {
    asked.emplace(key);
    return table.get(key);
  }

  /// Where a key stands, to begin a sentence: "my.toml:7: ".
  std::string place(std::string_view key) const
  {
    const auto change = changed.find(key);
    if (change != changed.end())
      return "--set " + path + std::string(key) + "=" + tomltext::shown(change->second) + ": ";
    const int keyLine = lineOf(key);
    return placeOfLine(keyLine != 0 ? keyLine : line);
  }

  /// The line of a key; 0 if it is not there or did not come from the file.
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

  /// The keys of the file that nobody asked for.
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

  /// The first mistake in this table and those in it; empty if there is none.
  std::string firstError() const
  {
    const std::vector<std::string> unknown = unknownKeys();

    // A misspelled key is why the right one is missing: the misspelling says more.
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

  /// A table in this one, which keeps its own mistakes and is looked at by firstError() of this.
  /// Asked for twice, it is the same.
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
