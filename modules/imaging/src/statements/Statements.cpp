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

std::string sentence(const std::string& subject, const StatedTwice& pair, const std::string& first,
                     const std::string& second, const std::string& which)
{
  return subject + " states " + pair.quantity + which + " twice: " + first + " in " + pair.first +
         " and " + second + " in " + pair.second + "; " + pair.remedy + ".";
}

}  // namespace

std::optional<std::string> disagreement(const std::string& subject, const StatedTwice& pair,
                                        double first, double second, const std::string& which)
{
  if (agree(pair, first, second)) return std::nullopt;
  // as many digits as tell them apart
  constexpr int minDigits = 4, maxDigits = 17;
  int digits = minDigits;
  while (digits < maxDigits && digitsOf(first, digits) == digitsOf(second, digits)) ++digits;
  const std::string unit = *pair.unit == '\0' ? "" : std::string(" ") + pair.unit;
  return sentence(subject, pair, digitsOf(first, digits) + unit, digitsOf(second, digits) + unit,
                  which);
}

std::optional<std::string> disagreement(const std::string& subject, const StatedTwice& pair,
                                        const std::string& first, const std::string& second,
                                        const std::string& which)
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
