// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/figures/Strings.h"

#include <charconv>

namespace perilymph::figures {

std::string fixed(double value, int digits)
{
  char text[400];
  const auto end = std::to_chars(text, text + sizeof text, value, std::chars_format::fixed, digits);
  return {text, end.ptr};
}

std::string withDecimalSign(std::string number, char decimalSign)
{
  if (const auto place = number.find('.'); place != std::string::npos) number[place] = decimalSign;
  return number;
}

std::string filled(std::string text, const std::vector<std::string>& numbers)
{
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const std::string mark = "%" + std::to_string(i + 1);
    if (const auto place = text.find(mark); place != std::string::npos)
      text.replace(place, mark.size(), numbers[i]);
  }
  return text;
}

}  // namespace perilymph::figures
