// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Headers of plain text, as of NRRD and MetaImage.

#include <cstddef>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "../statements/Statements.h"

namespace perilymph::imaging {

/// Fields of a header by name in lower case without blanks, and where it ends.
class HeaderFields {
public:
  /// Adds a field. False if the same field was there with another value, which `conflict` then says.
  bool add(const std::string& name, const std::string& value, const std::string& subject,
           const StatedTwice& pair);

  bool has(const std::string& name) const { return values_.contains(name); }
  /// The value, trimmed; empty if it is absent.
  std::string text(const std::string& name) const;
  /// The same in lower case.
  std::string word(const std::string& name) const;
  /// Numbers of the value; empty where it is absent or a word is no number.
  std::vector<double> numbers(const std::string& name) const;

  Sentence conflict;     ///< The sentence about a broken field or one of two values; may be empty.
  std::string modality;  ///< As a key of the user states it; may be empty.
  std::size_t end = 0;   ///< The first byte behind the header.

private:
  std::map<std::string, std::string> values_;
};

std::string lowerCase(std::string text);

/// Without blanks at both ends.
std::string trimmed(const std::string& text);

/// The words of a text; between quotes, blanks belong to a word.
std::vector<std::string> wordsOf(const std::string& text);

/// The first bytes of a file, at most 64 kB; empty if it cannot be read.
std::string headOf(const std::filesystem::path& file);

/// Lines of a text, without their ends; each with the place behind it.
struct HeaderLine {
  std::string text;
  std::size_t end;
};
std::optional<HeaderLine> lineAt(const std::string& content, std::size_t start);

/// Millimeters of a unit of length by name or symbol; empty for what is none.
std::optional<double> millimetersOf(const std::string& unit);

/// The file of the same folder that a header names; empty for one elsewhere.
std::optional<std::filesystem::path> besideHeader(const std::filesystem::path& header,
                                                  const std::string& name);

}  // namespace perilymph::imaging
