// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Formatting of numbers and texts in figures.

#include <string>
#include <vector>

namespace perilymph::figures {

/// A number with a fixed number of decimals.
std::string fixed(double value, int digits);

/// A number formatted by printf, with the decimal sign of a language.
std::string withDecimalSign(std::string number, char decimalSign);

/// A text with numbers in place of %1, %2.
std::string filled(std::string text, const std::vector<std::string>& numbers);

}  // namespace perilymph::figures
