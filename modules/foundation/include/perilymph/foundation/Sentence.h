// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Sentences for the user that can be shown in another language: a phrase of this program with places
// %1 to %9, and the values in them.

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <filesystem>
#include <ostream>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace perilymph {

/// English of this program: a sentence or a part of one, with %1 to %9 where values stand. What is
/// written as Phrase{"..."}, Sentence{"..."} or Error{"..."} below modules/ is collected for
/// translators (resources/translations/phrases.py).
class Phrase {
public:
  /// @param english  Lives as long as the program.
  constexpr explicit Phrase(const char* english) : english_(english) {}

  constexpr const char* english() const noexcept { return english_; }

private:
  const char* english_;
};

/// A phrase with as many places as there are values; another number does not compile.
template <class... Values>
class PhraseOf : public Phrase {
public:
  consteval PhraseOf(const char* english) : Phrase(english)
  {
    std::size_t places = 0;
    for (const char* at = english; *at != '\0'; ++at)
      if (*at == '%' && at[1] >= '1' && at[1] <= '9')
        places = std::max<std::size_t>(places, static_cast<std::size_t>(at[1] - '0'));
    if (places != sizeof...(Values)) throw "The places %1 to %9 are not those of the values.";
  }
};

/// The phrase with its places filled.
std::string filled(std::string_view phrase, std::span<const std::string> values);

/// A text in English that still has its phrase and its values, so that it can be shown in another
/// language. It is a std::string, because most of the program prints it as it is; a text put together
/// of parts by `+` is in English for good.
class Sentence : public std::string {
public:
  Sentence() = default;

  /// A phrase without values.
  template <std::size_t size>
  Sentence(const char (&phrase)[size]) : Sentence(Phrase(phrase))
  {
  }

  /// A phrase with one to nine values: numbers, names, paths or other sentences.
  template <class First, class... Others>
  Sentence(PhraseOf<std::type_identity_t<First>, std::type_identity_t<Others>...> phrase,
           const First& first, const Others&... others)
      : Sentence(Phrase(phrase), {valueOf(first), valueOf(others)...})
  {
  }

  /// A phrase that is chosen while the program runs.
  explicit Sentence(Phrase phrase, std::vector<Sentence> values = {});

  /// What has no phrase of this program: a name, a path, a text out of a file.
  template <std::same_as<std::string> Text>
  Sentence(Text text) : std::string(std::move(text))
  {
  }

  /// Null for what has none.
  const char* phrase() const noexcept { return phrase_; }
  const std::vector<Sentence>& values() const noexcept { return values_; }

  friend void PrintTo(const Sentence& sentence, std::ostream* out)
  {
    *out << '"' << static_cast<const std::string&>(sentence) << '"';
  }

private:
  using std::string::operator+=, std::string::append, std::string::insert, std::string::replace;

  static Sentence valueOf(const Sentence& sentence) { return sentence; }
  static Sentence valueOf(const std::string& text) { return text; }
  static Sentence valueOf(const char* text) { return std::string(text); }
  static Sentence valueOf(const std::filesystem::path& path) { return path.string(); }
  static Sentence valueOf(char letter) { return std::string(1, letter); }
  static Sentence valueOf(std::integral auto number) { return std::to_string(number); }

  const char* phrase_ = nullptr;
  std::vector<Sentence> values_;
};

/// A text out of a file, written as one of these phrases with values, as that sentence; another text
/// as it is.
Sentence recognized(const std::string& text, std::span<const Phrase> phrases);

}  // namespace perilymph
