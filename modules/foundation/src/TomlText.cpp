// SPDX-License-Identifier: BSD-3-Clause
#include "TomlText.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <locale>
#include <sstream>

#include "perilymph/foundation/TomlQuoted.h"
#include "perilymph/foundation/Utf8.h"

namespace perilymph {

std::string tomlQuoted(std::string_view text)
{
  std::string result = "\"";
  for (const char c : text) {
    const auto code = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\') {
      result += '\\';
      result += c;
    } else if (code < 0x20 || code == 0x7f) {
      constexpr char digits[] = "0123456789abcdef";
      result += "\\u00";
      result += digits[code >> 4];
      result += digits[code & 15];
    } else {
      result += c;
    }
  }
  return result + '"';
}

}  // namespace perilymph

namespace perilymph::tomltext {
namespace {

bool isBareKey(char c)
{
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
         c == '-';
}

/// End of the string whose opening quotation mark is at `begin`; counts line breaks.
std::size_t endOfString(std::string_view text, std::size_t begin, int& line)
{
  const char mark = text[begin];
  const std::string three(3, mark);
  const bool isLong = text.substr(begin, 3) == three;
  std::size_t i = begin + (isLong ? 3 : 1);
  for (; i < text.size(); ++i) {
    if (mark == '"' && text[i] == '\\') {
      ++i;
    } else if (isLong && text.substr(i, 3) == three) {
      return i + 3;
    } else if (!isLong && (text[i] == mark || text[i] == '\n')) {
      return text[i] == mark ? i + 1 : i;
    }
    if (i < text.size() && text[i] == '\n') ++line;
  }
  return text.size();
}

std::string writtenKey(std::string_view key)
{
  bool isBare = !key.empty();
  for (const char c : key) isBare = isBare && isBareKey(c);
  return isBare ? std::string(key) : tomlQuoted(key);
}

template <class Value>
std::string streamed(const Value& value)
{
  std::ostringstream stream;
  stream.imbue(std::locale::classic());
  stream << value;
  return stream.str();
}

/// A value on one line; tables as { a = 1, b = 2 }.
std::string writtenValue(const toml::node& node)
{
  if (const auto* text = node.as_string()) return tomlQuoted(text->get());
  if (const auto* whole = node.as_integer()) return std::to_string(whole->get());
  if (const auto* number = node.as_floating_point()) return tomlNumber(number->get());
  if (const auto* flag = node.as_boolean()) return flag->get() ? "true" : "false";
  if (const auto* date = node.as_date()) return streamed(date->get());
  if (const auto* time = node.as_time()) return streamed(time->get());
  if (const auto* moment = node.as_date_time()) return streamed(moment->get());
  std::string result;
  if (const auto* list = node.as_array()) {
    for (const toml::node& entry : *list)
      result += (result.empty() ? "" : ", ") + writtenValue(entry);
    return "[" + result + "]";
  }
  for (const auto& [key, value] : *node.as_table())
    result += (result.empty() ? "" : ", ") + writtenKey(key.str()) + " = " + writtenValue(value);
  return result.empty() ? "{}" : "{ " + result + " }";
}

void write(const toml::table& table, const std::string& path, std::string& result)
{
  for (const auto& [key, value] : table)
    if (!value.is_table()) result += writtenKey(key.str()) + " = " + writtenValue(value) + "\n";
  for (const auto& [key, value] : table) {
    const toml::table* inner = value.as_table();
    if (inner == nullptr) continue;
    const std::string innerPath = (path.empty() ? "" : path + ".") + writtenKey(key.str());
    result += (result.empty() ? "[" : "\n[") + innerPath + "]\n";
    write(*inner, innerPath, result);
  }
}

}  // namespace

std::optional<int> lineNotUtf8(std::string_view text)
{
  int line = 1;
  while (!text.empty()) {
    const std::size_t length = firstCharacter(text).length;
    if (length == 0) return line;
    if (text.front() == '\n') ++line;
    text.remove_prefix(length);
  }
  return std::nullopt;
}

std::optional<int> lineNestedTooDeep(std::string_view text)
{
  constexpr int maxDots = 15;
  int line = 1;
  int dots = 0;
  for (std::size_t i = 0; i < text.size();) {
    const char c = text[i];
    if (c == '"' || c == '\'') {
      i = endOfString(text, i, line);
      continue;
    }
    if (c == '#') {
      i = std::min(text.find('\n', i), text.size());
      continue;
    }
    if (c == '.' && ++dots > maxDots) return line;
    if (c == '\n') ++line;
    if (!isBareKey(c) && c != '.' && c != ' ' && c != '\t') dots = 0;
    ++i;
  }
  return std::nullopt;
}

std::string shortest(double value)
{
  if (std::isnan(value)) return "nan";
  if (std::isinf(value)) return value < 0 ? "-inf" : "inf";

  // Without an exponent in the usual range of magnitudes.
  const double size = std::fabs(value);
  const bool isPlain = value == 0.0 || (size >= 1e-4 && size < 1e9);
  char buffer[32];
  const auto end = std::to_chars(buffer, buffer + sizeof buffer, value,
                                 isPlain ? std::chars_format::fixed : std::chars_format::scientific)
                       .ptr;
  return std::string(buffer, end);
}

std::string tomlNumber(double value)
{
  const std::string digits = shortest(value);
  const bool isFloat = digits.find_first_of(".en") != std::string::npos;
  return isFloat ? digits : digits + ".0";
}

std::string shown(std::string_view text)
{
  constexpr std::size_t maxLength = 60;
  std::string result;
  while (!text.empty() && result.size() < maxLength) {
    const std::size_t length = firstCharacter(text).length;
    const auto first = static_cast<unsigned char>(text.front());
    if (length == 0 || first < 0x20 || first == 0x7f)
      result += '?';
    else
      result += text.substr(0, length);
    text.remove_prefix(length == 0 ? 1 : length);
  }
  return text.empty() ? result : result + "...";
}

std::string shown(const toml::node& node)
{
  if (const auto* text = node.as_string()) return "'" + shown(text->get()) + "'";
  if (const auto* number = node.as_floating_point()) return shortest(number->get());
  if (node.is_array()) return "a list";
  if (node.is_table()) return "a table";
  return writtenValue(node);
}

std::string listed(const std::vector<std::string>& words)
{
  std::string all;
  for (const std::string& word : words) all += (all.empty() ? "" : ", ") + word;
  return all;
}

std::string written(const toml::table& table)
{
  std::string result;
  write(table, "", result);
  return result;
}

}  // namespace perilymph::tomltext
