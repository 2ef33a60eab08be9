// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/figures/Lines.h"

#include <algorithm>
#include <sstream>

namespace perilymph::figures {

double widthOf(const std::string& text, double size)
{
  constexpr double perLetter = 0.53;  // of the size: slightly more than Inter's mean width
  const auto isFirstByte = [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; };
  const auto letters = std::count_if(text.begin(), text.end(), isFirstByte);
  return perLetter * size * static_cast<double>(letters);
}

std::vector<std::string> linesOf(const std::string& text, double size, double width)
{
  std::vector<std::string> lines{""};
  std::istringstream rest(text);
  for (std::string word; rest >> word;) {
    const std::string longer = lines.back().empty() ? word : lines.back() + " " + word;
    if (lines.back().empty() || widthOf(longer, size) <= width)
      lines.back() = longer;
    else
      lines.push_back(word);
  }
  return lines;
}

}  // namespace perilymph::figures
