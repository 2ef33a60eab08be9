#pragma once

// The one place where this program prints: what comes from files, devices and the call is shown,
// and steers no terminal.

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

/// Number of places for values in a format.
constexpr std::size_t placesIn(std::string_view format)
{
  std::size_t places = 0;
  for (const char letter : format) places += letter == '{' ? 1 : 0;
  return places;
}

/// A format with a place for each value, checked by the compiler: `{}`, `{:8}` and `{:<8}` (at
/// least eight characters, to the left), `{:>8}` (to the right), as in C++20's std::format. Its own
/// text is printed as it is.
template <class... Values>
struct Format {
  consteval Format(const char* written) : text(written)
  {
    if (placesIn(text) != sizeof...(Values)) throw "a format needs one place for each value";
  }
  const char* text;
};

/// A value as it is printed: text through printable(), whole numbers in digits.
inline std::string shown(std::string_view text) { return printable(text); }
std::string shown(const std::same_as<std::filesystem::path> auto& file)
{
  return printable(file.string());
}
std::string shown(std::integral auto number) { return std::to_string(number); }

/// Prints a text of this program's own, lines included, to standard output.
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

/// Shows what was printed so far.
void flushOutput();

/// Shows what was printed, at the end of the program. A sentence where standard output did not take
/// all of it, as on a full disk.
Result<Done> finishOutput();

/// Makes every standard stream open, so that no file of the program takes the number of a closed
/// one and what is printed goes into it.
void openStandardStreams();

/// A number with a sensible number of digits after the point, for people.
std::string fixed(double value, int digits);

}  // namespace perilymph::cli
