// SPDX-License-Identifier: BSD-3-Clause
#include "SurfaceText.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <map>
#include <sstream>
#include <string_view>

namespace perilymph::imaging {
namespace {

bool isDigit(char c) { return c >= '0' && c <= '9'; }

bool isPlain(std::string_view text)
{
  return std::all_of(text.begin(), text.end(),
                     [](char c) { return (c >= ' ' && c <= '~') || c == '\r' || c == '\t'; });
}

/// The line from a place on, without its end; the place moves behind it.
std::string_view nextLine(const std::string& content, std::size_t& at)
{
  const std::size_t stop = std::min(content.find('\n', at), content.size());
  const std::string_view line(content.data() + at, stop - at);
  at = std::min(stop + 1, content.size());
  return line;
}

/// The first word of a line.
std::string_view firstWord(std::string_view line)
{
  const std::size_t first = std::min(line.find_first_not_of(" \t\r"), line.size());
  return line.substr(first, std::min(line.find_first_of(" \t\r", first), line.size()) - first);
}

struct NumberType {
  std::size_t bytes;
  bool isInteger;
};

std::optional<NumberType> plyType(const std::string& name)
{
  static const std::map<std::string, NumberType> types = {
      {"char", {1, true}},    {"int8", {1, true}},     {"uchar", {1, true}},
      {"uint8", {1, true}},   {"short", {2, true}},    {"int16", {2, true}},
      {"ushort", {2, true}},  {"uint16", {2, true}},   {"int", {4, true}},
      {"int32", {4, true}},   {"uint", {4, true}},     {"uint32", {4, true}},
      {"float", {4, false}},  {"float32", {4, false}}, {"double", {8, false}},
      {"float64", {8, false}}};
  const auto found = types.find(name);
  if (found == types.end()) return std::nullopt;
  return found->second;
}

/// Takes a line of the header; false if it is none.
bool takeLine(std::string_view text, PlyHeader& header)
{
  std::istringstream words{std::string(text)};
  std::string word, one, two, name;
  words >> word;
  if (word.empty() || word == "comment" || word == "obj_info" || word == "ply") return true;
  words >> one;
  if (word == "format") {
    header.isText = one == "ascii";
    return header.isText || one == "binary_little_endian" || one == "binary_big_endian";
  }
  if (word == "element") {
    header.elements.push_back({.name = one, .count = 0, .names = {}, .lists = {}});
    return bool(words >> header.elements.back().count);
  }
  if (word != "property" || header.elements.empty()) return false;
  PlyElement& element = header.elements.back();
  if (one != "list") {
    const auto type = plyType(one);
    if (!type || !(words >> name)) return false;
    element.names.push_back(name);
    element.numberBytes += type->bytes;
    element.isInteger = element.isInteger && type->isInteger;
    return true;
  }
  words >> one >> two;
  const auto count = plyType(one), item = plyType(two);
  if (!count || !item || !(words >> name)) return false;
  element.lists.push_back({name, count->bytes, item->bytes});
  element.isInteger = element.isInteger && item->isInteger;
  return true;
}

/// How many numbers a line holds; empty if a word is none, or none of the kind.
std::optional<std::size_t> numbersInLine(std::string_view line, bool isInteger)
{
  std::size_t count = 0;
  for (;;) {
    const std::string_view word = firstWord(line);
    if (word.empty()) return count;
    line.remove_prefix(static_cast<std::size_t>(word.data() + word.size() - line.data()));
    const char* const end = word.data() + word.size();
    long long integer = 0;
    double number = 0.0;
    const auto parsed = isInteger ? std::from_chars(word.data(), end, integer)
                                  : std::from_chars(word.data(), end, number);
    if (parsed.ec != std::errc{} || parsed.ptr != end) return std::nullopt;
    ++count;
  }
}

/// Whether a line holds what its element has: numbers, then what the only list counts.
bool isElementsLine(std::string_view line, const PlyElement& element)
{
  const auto numbers = numbersInLine(line, element.isInteger);
  if (!numbers) return false;
  if (element.lists.empty()) return *numbers == element.names.size();
  if (element.lists.size() > 1 || !element.names.empty()) return *numbers > element.names.size();
  const std::string_view word = firstWord(line);
  std::size_t count = 0;
  std::from_chars(word.data(), word.data() + word.size(), count);
  constexpr std::size_t maxCorners = 255;  // VTK counts them in a byte
  return count <= maxCorners && *numbers == count + 1;
}

}  // namespace

std::optional<std::string> namelessStl(const std::string& content)
{
  if (content.rfind("solid", 0) != 0) return std::nullopt;
  std::string text;
  bool hasFacets = false;
  for (std::size_t at = 0; at < content.size();) {
    const std::string_view line = nextLine(content, at);
    const std::string_view word = firstWord(line);
    if (word == "solid" || word == "endsolid") {
      text += word;
    } else {
      if (!isPlain(line)) return std::nullopt;
      hasFacets = hasFacets || word == "facet";
      text += line;
    }
    text += '\n';
  }
  if (!hasFacets) return std::nullopt;
  return text;
}

std::optional<std::string> commaNumber(const std::string& content, std::size_t from)
{
  for (std::size_t at = content.find(',', from); at != std::string::npos;
       at = content.find(',', at + 1)) {
    if (at == 0 || at + 1 == content.size() || !isDigit(content[at - 1]) ||
        !isDigit(content[at + 1]))
      continue;
    std::size_t first = at, last = at + 1;
    while (first > from && (isDigit(content[first - 1]) || content[first - 1] == '-')) --first;
    while (last < content.size() && isDigit(content[last])) ++last;
    constexpr std::size_t longest = 24;
    return content.substr(first, std::min(last - first, longest));
  }
  return std::nullopt;
}

const PlyElement* PlyHeader::find(const std::string& name) const
{
  for (const PlyElement& element : elements)
    if (element.name == name) return &element;
  return nullptr;
}

std::optional<PlyHeader> plyHeader(const std::string& content)
{
  if (content.rfind("ply", 0) != 0) return std::nullopt;
  PlyHeader header;
  while (header.end < content.size()) {
    const std::string_view line = nextLine(content, header.end);
    if (firstWord(line) == "end_header") {
      if (header.end == 0 || content[header.end - 1] != '\n') return std::nullopt;
      return header;
    }
    if (!takeLine(line, header)) return std::nullopt;
  }
  return std::nullopt;
}

Result<void> checkPly(const PlyHeader& header, const std::string& content)
{
  for (const PlyElement& element : header.elements)
    if (element.count > maxPlyElements)
      return Error{
          "states %1 elements '%2'; at most 5 million are read. Export the surface of the cochlea "
          "alone.",
          element.count, element.name};
  const PlyElement* const points = header.find("vertex");
  const PlyElement* const faces = header.find("face");
  const auto has = [points](const char* name) {
    return std::find(points->names.begin(), points->names.end(), name) != points->names.end();
  };
  if (!points || !has("x") || !has("y") || !has("z"))
    return Error{"has no points with x, y and z. Export it again from the segmentation program."};
  const auto isCorners = [](const PlyList& list) {
    return list.name == "vertex_indices" || list.name == "vertex_index";
  };
  if (!faces || std::none_of(faces->lists.begin(), faces->lists.end(), isCorners))
    return Error{
        "has no faces with a list of their corners. Export it again from the segmentation "
        "program."};
  if (!header.isText) return {};
  std::size_t at = header.end;
  const Error notThem{
      "is not a whole .ply file: it does not hold the points and faces that its header states, "
      "one line of numbers each. Export it again from the segmentation program."};
  for (const PlyElement& element : header.elements)
    for (std::size_t i = 0; i < element.count; ++i) {
      if (at >= content.size() || !isElementsLine(nextLine(content, at), element)) return notThem;
    }
  while (at < content.size())
    if (!firstWord(nextLine(content, at)).empty()) return notThem;
  return {};
}

std::optional<std::size_t> plyDataBytes(const PlyHeader& header, std::size_t corners)
{
  std::size_t bytes = 0;
  for (const PlyElement& element : header.elements) {
    bytes += element.count * element.numberBytes;
    if (element.lists.empty() || element.count == 0) continue;
    if (element.name != "face" || element.lists.size() > 1) return std::nullopt;
    bytes += element.count * element.lists[0].countBytes + corners * element.lists[0].itemBytes;
  }
  return bytes;
}

}  // namespace perilymph::imaging
