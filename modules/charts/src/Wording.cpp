#include "perilymph/charts/Wording.h"

#include <utility>

namespace perilymph::charts {

namespace {

Wording& current()
{
  static Wording words;
  return words;
}

}  // namespace

void setWording(Wording wording) { current() = std::move(wording); }
const Wording& wording() { return current(); }

std::string filled(std::string words, const std::vector<std::string>& numbers)
{
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const std::string mark = "%" + std::to_string(i + 1);
    if (const auto place = words.find(mark); place != std::string::npos)
      words.replace(place, mark.size(), numbers[i]);
  }
  return words;
}

std::string withDecimalSign(std::string number)
{
  if (const auto place = number.find('.'); place != std::string::npos)
    number[place] = wording().decimalSign;
  return number;
}

}  // namespace perilymph::charts
