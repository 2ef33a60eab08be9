// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/foundation/Sentence.h"

#include <optional>

namespace perilymph {
namespace {

/// The number of the place at a position: 1 to 9; 0 where there is none.
std::size_t placeAt(std::string_view phrase, std::size_t at)
{
  const bool isPlace =
      phrase[at] == '%' && at + 1 < phrase.size() && phrase[at + 1] >= '1' && phrase[at + 1] <= '9';
  return isPlace ? static_cast<std::size_t>(phrase[at + 1] - '0') : 0;
}

/// What stands in the places of a phrase, which are in their order; empty if the text is another one.
std::optional<std::vector<Sentence>> valuesIn(std::string_view phrase, std::string_view text)
{
  std::vector<Sentence> values;
  for (std::size_t at = 0; at < phrase.size();) {
    const bool isPlace = placeAt(phrase, at) != 0;
    if (isPlace) at += 2;
    std::size_t end = at;
    while (end < phrase.size() && placeAt(phrase, end) == 0) ++end;
    const std::string_view fixed = phrase.substr(at, end - at);
    const std::size_t found = isPlace && end == phrase.size()
                                  ? text.size() - std::min(text.size(), fixed.size())
                                  : text.find(fixed);
    if (found == std::string_view::npos || !text.substr(found).starts_with(fixed) ||
        (found > 0) != isPlace)
      return std::nullopt;
    if (isPlace) values.emplace_back(std::string(text.substr(0, found)));
    text.remove_prefix(found + fixed.size());
    at = end;
  }
  if (!text.empty()) return std::nullopt;
  return values;
}

}  // namespace

std::string filled(std::string_view phrase, std::span<const std::string> values)
{
  std::string text;
  for (std::size_t at = 0; at < phrase.size(); ++at) {
    const std::size_t place = placeAt(phrase, at);
    if (place == 0 || place > values.size()) {
      text += phrase[at];
      continue;
    }
    text += values[place - 1];
    ++at;
  }
  return text;
}

Sentence::Sentence(Phrase phrase, std::vector<Sentence> values)
    : std::string(filled(phrase.english(), std::vector<std::string>(values.begin(), values.end()))),
      phrase_(phrase.english()),
      values_(std::move(values))
{
}

Sentence recognized(const std::string& text, std::span<const Phrase> phrases)
{
  for (const Phrase& phrase : phrases)
    if (auto values = valuesIn(phrase.english(), text)) return Sentence(phrase, *std::move(values));
  return text;
}

}  // namespace perilymph
