#include "perilymph/charts/ChartStrings.h"

#include <utility>

namespace perilymph::charts {

namespace {

ChartStrings& current()
{
  static ChartStrings text;
  return text;
}

}  // namespace

void setChartStrings(ChartStrings strings) { current() = std::move(strings); }
const ChartStrings& chartStrings() { return current(); }

std::string filled(std::string text, const std::vector<std::string>& numbers)
{
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const std::string mark = "%" + std::to_string(i + 1);
    if (const auto place = text.find(mark); place != std::string::npos)
      text.replace(place, mark.size(), numbers[i]);
  }
  return text;
}

std::string withDecimalSign(std::string number)
{
  if (const auto place = number.find('.'); place != std::string::npos)
    number[place] = chartStrings().decimalSign;
  return number;
}

}  // namespace perilymph::charts
