// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/foundation/Seal.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cstdint>

namespace perilymph {

namespace {

constexpr std::size_t digits = 64;  // of SHA-256

/// Where the digits of the seal begin in a JSON text; npos without one. In a JSON string every
/// quotation mark follows a backslash, so that no other text looks like the key.
std::size_t placeOfSeal(std::string_view json)
{
  const std::string key = std::string("\"") + sealKey + "\": \"";
  const std::size_t found = json.rfind(key);
  if (found == std::string_view::npos || json.size() < found + key.size() + digits)
    return std::string_view::npos;
  return found + key.size();
}

std::string hashOf(std::string_view text)
{
  Sha256 hash;
  hash.add(text);
  return hash.hex();
}

Seal withoutSeal(bool isInFormat, std::string_view program)
{
  return isInFormat || hasToBeSealed(program) ? Seal::changed : Seal::absent;
}

}  // namespace

Sentence noteOn(Seal seal)
{
  switch (seal) {
    case Seal::intact:
      return {};
    case Seal::absent:
      return Sentence{"This file carries no seal: it is of an earlier version of the program."};
    case Seal::changed:
      break;
  }
  return Sentence{
      "This file was changed by hand after the program wrote it, so it has no number. Do not "
      "use "
      "its values as results of the program."};
}

bool hasToBeSealed(std::string_view program, Release since)
{
  constexpr std::string_view name = "perilymph ";
  const bool isNamed = program.size() >= name.size() &&
                       std::equal(name.begin(), name.end(), program.begin(), [](char a, char b) {
                         return a == std::tolower(static_cast<unsigned char>(b));
                       });
  if (isNamed) program.remove_prefix(name.size());
  Release release;
  const char* const end = program.data() + program.size();
  const auto [dot, problem] = std::from_chars(program.data(), end, release.major);
  if (problem != std::errc() || dot == end || *dot != '.') return false;
  if (std::from_chars(dot + 1, end, release.minor).ec != std::errc()) return false;
  return release >= since;
}

std::string sealOver(const SealedFacts& facts, const Sha256& rows)
{
  Sha256 hash;
  for (const auto& [key, value] : facts) {
    if (key == sealKey) continue;
    for (const std::string& text : {key, value}) {
      hash.add(std::uint64_t{text.size()});
      hash.add(std::string_view(text));
    }
  }
  hash.add(std::string_view(rows.hex()));
  return hash.hex();
}

Seal sealIn(const SealedFacts& facts, const Sha256& rows, bool isInFormat, std::string_view program)
{
  const auto seal = facts.find(sealKey);
  if (seal == facts.end()) return withoutSeal(isInFormat, program);
  return isInFormat && seal->second == sealOver(facts, rows) ? Seal::intact : Seal::changed;
}

std::string sealToBe() { return std::string(digits, '0'); }

std::string sealed(std::string json)
{
  const std::string seal = hashOf(json);
  if (const std::size_t place = placeOfSeal(json); place != std::string::npos)
    json.replace(place, digits, seal);
  return json;
}

Seal sealIn(std::string_view json, bool isInFormat, std::string_view program)
{
  const std::size_t place = placeOfSeal(json);
  if (place == std::string_view::npos) return withoutSeal(isInFormat, program);
  std::string without(json);
  without.replace(place, digits, sealToBe());
  return isInFormat && json.substr(place, digits) == hashOf(without) ? Seal::intact : Seal::changed;
}

}  // namespace perilymph
