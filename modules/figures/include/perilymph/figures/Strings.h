#pragma once

// Numbers and texts as figures show them.

#include <string>
#include <vector>

namespace perilymph::figures {

/// A number with so many digits after the point.
std::string fixed(double value, int digits);

/// A number as printf writes it, with the decimal sign of a language.
std::string withDecimalSign(std::string number, char decimalSign);

/// A text with numbers in place of %1, %2.
std::string filled(std::string text, const std::vector<std::string>& numbers);

}  // namespace perilymph::figures
