// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The only place where this program prints: text from files, devices and the call is escaped, so
// that it cannot control the terminal.

#include <array>
#include <concepts>
#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>

#include "Printable.h"
#include "perilymph/foundation/Result.h"

namespace perilymph::cli {

/// Number of placeholders in a format.
constexpr std::size_t placesIn(std::string_view format)
{
  std::size_t places = 0;
  for (const char letter : format) places += letter == '{' ? 1 : 0;
  return places;
}

/// A format with a placeholder for each value, checked by the compiler: `{}`, `{:8}` and `{:<8}`
/// (at least eight characters, left-aligned), `{:>8}` (right-aligned), as in C++20's std::format.
/// Its own text is printed unchanged.
template <class... Values>
struct Format {
  consteval Format(const char* written) : text(written)
  {
    if (placesIn(text) != sizeof...(Values)) throw "a format needs one place for each value";
  }
  const char* text;
};

/// A value as printed: text through printable(), integers in digits.
inline std::string shown(std::string_view text) { return printable(text); }
std::string shown(const std::same_as<std::filesystem::path> auto& file)
{
  return printable(file.string());
}
std::string shown(std::integral auto number) { return std::to_string(number); }

/// Prints a text of this program, possibly of several lines, to standard output.
void printText(const std::string& text);

/// Prints to standard output.
void printFilled(const char* format, std::span<const std::string> values);
/// Prints to standard error.
void printErrorFilled(const char* format, std::span<const std::string> values);

template <class... Values>
void print(std::type_identity_t<Format<Values...>> format, const Values&... values)
{
  const std::array<std::string, sizeof...(Values)> texts = {shown(values)...};
  printFilled(format.text, texts);
}

template <class... Values>
void printError(std::type_identity_t<Format<Values...>> format, const Values&... values)
{
  const std::array<std::string, sizeof...(Values)> texts = {shown(values)...};
  printErrorFilled(format.text, texts);
}

/// Flushes standard output.
void flushOutput();

/// Flushes standard output at the end of the program. An error if it was not written completely, as
/// on a full disk.
Result<void> finishOutput();

/// Opens closed standard streams, so that no file of the program gets the descriptor of one and
/// receives printed text.
void openStandardStreams();

/// A number with a fixed number of decimals.
std::string fixed(double value, int digits);

}  // namespace perilymph::cli
