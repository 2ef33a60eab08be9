// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/analysis/IncompleteInsertion.h"

#include <algorithm>
#include <array>

namespace perilymph::analysis {

using haptics::InsertionEnd;

namespace {

constexpr std::size_t maxNumbersListed = 5;

/// "number 25", "numbers 25 and 30", "numbers 1, 2, 3, 4, 5 and 7 more".
std::string numbersText(const std::vector<std::uint64_t>& numbers)
{
  std::string text = numbers.size() == 1 ? "number " : "numbers ";
  const std::size_t listed = std::min(numbers.size(), maxNumbersListed);
  for (std::size_t i = 0; i < listed; ++i) {
    const bool isLast = i + 1 == numbers.size();
    text += (i == 0 ? "" : isLast ? " and " : ", ") + std::to_string(numbers[i]);
  }
  if (numbers.size() > listed) text += " and " + std::to_string(numbers.size() - listed) + " more";
  return text;
}

}  // namespace

std::string completionSentence(int runs, const std::vector<IncompleteInsertion>& incomplete)
{
  const std::string all = std::to_string(runs);
  if (incomplete.empty()) return "All " + all + " insertions reached the end.";
  std::string text = std::to_string(runs - static_cast<int>(incomplete.size())) + " of " + all +
                     " insertions reached the end";
  constexpr std::array ends = {InsertionEnd::outOfOpening,
                               InsertionEnd::buckled,
                               InsertionEnd::foldedTip,
                               InsertionEnd::jammed,
                               InsertionEnd::stoppedByResistance,
                               InsertionEnd::fault,
                               InsertionEnd::none};
  for (const InsertionEnd end : ends) {
    std::vector<std::uint64_t> numbers;
    for (const IncompleteInsertion& each : incomplete)
      if (each.end == end) numbers.push_back(each.number);
    if (numbers.empty()) continue;
    text += "; " + std::to_string(numbers.size()) + " " + clauseOf(end) + " (" +
            numbersText(numbers) + ")";
  }
  return text + ".";
}

}  // namespace perilymph::analysis
