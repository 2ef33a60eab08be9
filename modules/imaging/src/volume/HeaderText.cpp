// SPDX-License-Identifier: BSD-3-Clause
#include "HeaderText.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <fstream>
#include <sstream>

namespace perilymph::imaging {
namespace {

constexpr std::size_t maxHeaderBytes = 1u << 16;

}  // namespace

std::string lowerCase(std::string text)
{
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

std::string trimmed(const std::string& text)
{
  const std::size_t first = text.find_first_not_of(" \t\r");
  if (first == std::string::npos) return "";
  return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

std::vector<std::string> wordsOf(const std::string& text)
{
  std::vector<std::string> words;
  std::string word;
  bool isQuoted = false, isWord = false;
  for (const char c : text) {
    if (c == '"') {
      isQuoted = !isQuoted;
      isWord = true;
    } else if (!isQuoted && (c == ' ' || c == '\t')) {
      if (isWord) words.push_back(word);
      word.clear();
      isWord = false;
    } else {
      word += c;
      isWord = true;
    }
  }
  if (isWord) words.push_back(word);
  return words;
}

bool HeaderFields::add(const std::string& name, const std::string& value,
                       const std::string& subject, const StatedTwice& pair)
{
  std::string key = lowerCase(name);
  std::erase_if(key, [](char c) { return c == ' ' || c == '\t'; });
  const auto [there, isNew] = values_.emplace(key, trimmed(value));
  if (isNew) return true;
  const auto differs = disagreement(subject, pair, "'" + there->second + "'",
                                    "'" + trimmed(value) + "'", Sentence{", '%1',", trimmed(name)});
  if (!differs) return true;
  conflict = *differs;
  return false;
}

std::string HeaderFields::text(const std::string& name) const
{
  const auto found = values_.find(name);
  return found == values_.end() ? "" : found->second;
}

std::string HeaderFields::word(const std::string& name) const { return lowerCase(text(name)); }

std::vector<double> HeaderFields::numbers(const std::string& name) const
{
  std::vector<double> numbers;
  std::string spaced = text(name);
  for (char& c : spaced)
    if (c == '(' || c == ')' || c == ',') c = ' ';
  std::istringstream words(spaced);
  for (std::string word; words >> word;) {
    double number = 0.0;
    const char* const last = word.data() + word.size();
    const auto parsed = std::from_chars(word.data(), last, number);
    if (parsed.ec != std::errc{} || parsed.ptr != last) return {};
    numbers.push_back(number);
  }
  return numbers;
}

std::string headOf(const std::filesystem::path& file)
{
  std::ifstream stream(file, std::ios::binary);
  std::string content(maxHeaderBytes, '\0');
  stream.read(content.data(), static_cast<std::streamsize>(content.size()));
  content.resize(static_cast<std::size_t>(stream.gcount()));
  return content;
}

std::optional<HeaderLine> lineAt(const std::string& content, std::size_t start)
{
  const std::size_t stop = content.find('\n', start);
  if (start >= content.size() || stop == std::string::npos) return std::nullopt;
  std::string line = content.substr(start, stop - start);
  if (!line.empty() && line.back() == '\r') line.pop_back();
  return HeaderLine{line, stop + 1};
}

std::optional<double> millimetersOf(const std::string& unit)
{
  static const std::map<std::string, double> units = {
      {"mm", 1.0},           {"millimeter", 1.0},   {"millimeters", 1.0},  {"millimetre", 1.0},
      {"millimetres", 1.0},  {"um", 1e-3},          {"\xc2\xb5m", 1e-3},   {"\xce\xbcm", 1e-3},
      {"micron", 1e-3},      {"microns", 1e-3},     {"micrometer", 1e-3},  {"micrometers", 1e-3},
      {"micrometre", 1e-3},  {"micrometres", 1e-3}, {"cm", 10.0},          {"centimeter", 10.0},
      {"centimeters", 10.0}, {"centimetre", 10.0},  {"centimetres", 10.0}, {"m", 1e3},
      {"meter", 1e3},        {"meters", 1e3},       {"metre", 1e3},        {"metres", 1e3}};
  const auto found = units.find(lowerCase(trimmed(unit)));
  if (found == units.end()) return std::nullopt;
  return found->second;
}

std::optional<std::filesystem::path> besideHeader(const std::filesystem::path& header,
                                                  const std::string& name)
{
  const std::filesystem::path named(name.rfind("./", 0) == 0 ? name.substr(2) : name);
  if (named.empty() || named.has_parent_path() || named == "." || named == "..")
    return std::nullopt;
  return header.parent_path() / named;
}

}  // namespace perilymph::imaging
