// SPDX-License-Identifier: BSD-3-Clause
#include "Suggestion.h"

#include <algorithm>
#include <numeric>

namespace perilymph {
namespace {

/// Levenshtein distance of two words: letters to insert, remove or substitute.
std::size_t lettersApart(std::string_view a, std::string_view b)
{
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i + 1;
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t exchanged = diagonal + (a[i] == b[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({exchanged, row[j] + 1, row[j + 1] + 1});
    }
  }
  return row.back();
}

bool startsWithPart(std::string_view whole, std::string_view part)
{
  return whole.size() > part.size() && whole.substr(0, part.size()) == part &&
         whole[part.size()] == '_';
}

}  // namespace

std::string nearestWord(std::string_view word, const std::vector<std::string>& candidates)
{
  constexpr std::size_t longest = 100;
  if (word.empty() || word.size() > longest) return {};
  for (const std::string& candidate : candidates)
    if (startsWithPart(candidate, word) || startsWithPart(word, candidate)) return candidate;

  std::string nearest;
  std::size_t smallest = word.size() / 3 + 1;
  for (const std::string& candidate : candidates) {
    const std::size_t apart = lettersApart(word, candidate);
    if (apart >= smallest) continue;
    smallest = apart;
    nearest = candidate;
  }
  return nearest;
}

}  // namespace perilymph
