// SPDX-License-Identifier: BSD-3-Clause
#include "Statements.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace perilymph::imaging {
namespace {

std::string digitsOf(double value, int digits)
{
  std::array<char, 40> text{};  // in no language's notation
  const auto done = std::to_chars(text.data(), text.data() + text.size(), value,
                                  std::chars_format::general, digits);
  return {text.data(), done.ptr};
}

bool agree(const StatedTwice& pair, double first, double second)
{
  const double allowed =
      std::max(pair.relative * std::max(std::fabs(first), std::fabs(second)), pair.absolute);
  return std::isfinite(first) && std::isfinite(second) && std::fabs(first - second) <= allowed;
}

Sentence sentence(const Sentence& subject, const StatedTwice& pair, const Sentence& first,
                  const Sentence& second, const Sentence& which)
{
  return Sentence{"%1 states %2 twice: %3 in %4 and %5 in %6; %7.",
                  subject,
                  Sentence{"%1%2", Sentence(Phrase(pair.quantity)), which},
                  first,
                  Sentence(Phrase(pair.first)),
                  second,
                  Sentence(Phrase(pair.second)),
                  Sentence(Phrase(pair.remedy))};
}

}  // namespace

std::optional<Sentence> disagreement(const Sentence& subject, const StatedTwice& pair, double first,
                                     double second, const Sentence& which)
{
  if (agree(pair, first, second)) return std::nullopt;
  // as many digits as tell them apart
  constexpr int minDigits = 4, maxDigits = 17;
  int digits = minDigits;
  while (digits < maxDigits && digitsOf(first, digits) == digitsOf(second, digits)) ++digits;
  const auto measured = [&](double value) {
    const std::string number = digitsOf(value, digits);
    return *pair.unit == '\0' ? Sentence(number)
                              : Sentence{"%1 %2", number, Sentence(Phrase(pair.unit))};
  };
  return sentence(subject, pair, measured(first), measured(second), which);
}

std::optional<Sentence> disagreement(const Sentence& subject, const StatedTwice& pair,
                                     const Sentence& first, const Sentence& second,
                                     const Sentence& which)
{
  if (first == second) return std::nullopt;
  return sentence(subject, pair, first, second, which);
}

std::string rowOf(const StatedTwice& pair)
{
  std::string tolerance;
  if (pair.relative > 0.0) tolerance = digitsOf(100.0 * pair.relative, 3) + " %";
  if (pair.absolute > 0.0) {
    tolerance += tolerance.empty() ? "" : " or ";
    tolerance += digitsOf(pair.absolute, 3);
    if (*pair.unit != '\0') tolerance += std::string(" ") + pair.unit;
  }
  if (tolerance.empty()) tolerance = "none";
  return std::string("| ") + pair.format + " | " + pair.quantity + " | " + pair.first + " | " +
         pair.second + " | " + tolerance + " | " +
         (pair.answer == Disagreement::refuse ? "refused" : "warning") + " |";
}

}  // namespace perilymph::imaging
