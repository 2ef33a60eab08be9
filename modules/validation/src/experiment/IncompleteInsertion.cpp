// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/validation/IncompleteInsertion.h"

#include <algorithm>
#include <array>

namespace perilymph::validation {

using haptics::InsertionEnd;

namespace {

constexpr std::size_t maxNumbersListed = 5;

/// "number 25", "numbers 25 and 30", "numbers 1, 2, 3, 4, 5 and 7 more".
Sentence numbersText(const std::vector<std::uint64_t>& numbers)
{
  if (numbers.size() == 1) return Sentence{"number %1", numbers.front()};
  const std::size_t listed = std::min(numbers.size(), maxNumbersListed);
  const std::size_t more = numbers.size() - listed;
  std::string list = std::to_string(numbers.front());
  for (std::size_t i = 1; i < listed - (more == 0 ? 1 : 0); ++i)
    list += ", " + std::to_string(numbers[i]);
  if (more > 0) return Sentence{"numbers %1 and %2 more", list, more};
  return Sentence{"numbers %1 and %2", list, numbers.back()};
}

}  // namespace

Sentence completionSentence(int runs, const std::vector<IncompleteInsertion>& incomplete)
{
  if (incomplete.empty()) return Sentence{"All %1 insertions reached the end.", runs};
  Sentence text{"%1 of %2 insertions reached the end", runs - static_cast<int>(incomplete.size()),
                runs};
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
    text = Sentence{"%1; %2 %3 (%4)", text, numbers.size(), Sentence(Phrase(clauseOf(end))),
                    numbersText(numbers)};
  }
  return Sentence{"%1.", text};
}

}  // namespace perilymph::validation
