// SPDX-License-Identifier: BSD-3-Clause
#include "PlyFile.h"

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <map>
#include <sstream>
#include <vector>

namespace perilymph::imaging {
namespace {

enum class Format { text, littleEndian, bigEndian };

struct Type {
  std::size_t bytes;
  char kind;  // 'f' floating, 'i' signed, 'u' unsigned
};

const std::map<std::string, Type> types = {
    {"char", {1, 'i'}},  {"int8", {1, 'i'}},    {"uchar", {1, 'u'}},  {"uint8", {1, 'u'}},
    {"short", {2, 'i'}}, {"int16", {2, 'i'}},   {"ushort", {2, 'u'}}, {"uint16", {2, 'u'}},
    {"int", {4, 'i'}},   {"int32", {4, 'i'}},   {"uint", {4, 'u'}},   {"uint32", {4, 'u'}},
    {"float", {4, 'f'}}, {"float32", {4, 'f'}}, {"double", {8, 'f'}}, {"float64", {8, 'f'}}};

struct Property {
  std::string name;
  Type type;
  std::optional<Type> count;  // of a list
};

struct Element {
  std::string name;
  std::size_t count = 0;
  std::vector<Property> properties;
};

struct Header {
  Format format = Format::text;
  std::vector<Element> elements;
  std::size_t end = 0;  // offset of the data
};

std::optional<Type> typeNamed(const std::string& name)
{
  const auto found = types.find(name);
  if (found == types.end()) return std::nullopt;
  return found->second;
}

/// Parses one line of the header; false if it is invalid.
bool take(const std::string& line, Header& header)
{
  std::istringstream words(line);
  std::string word, one, two;
  words >> word;
  if (word.empty() || word == "comment" || word == "obj_info" || word == "ply") return true;
  words >> one;
  if (word == "format") {
    if (one == "ascii")
      header.format = Format::text;
    else if (one == "binary_little_endian")
      header.format = Format::littleEndian;
    else if (one == "binary_big_endian")
      header.format = Format::bigEndian;
    else
      return false;
    return true;
  }
  if (word == "element") {
    Element element{one, 0, {}};
    if (!(words >> element.count)) return false;
    header.elements.push_back(element);
    return true;
  }
  if (word != "property" || header.elements.empty()) return false;
  Property property;
  if (one == "list") {
    words >> one >> two;
    property.count = typeNamed(one);
    if (!property.count) return false;
  } else {
    two = one;
  }
  const auto type = typeNamed(two);
  if (!type || !(words >> property.name)) return false;
  property.type = *type;
  header.elements.back().properties.push_back(property);
  return true;
}

std::optional<Header> readHeader(const std::string& content)
{
  Header header;
  while (header.end < content.size()) {
    const std::size_t end = content.find('\n', header.end);
    if (end == std::string::npos) return std::nullopt;
    std::string line = content.substr(header.end, end - header.end);
    if (!line.empty() && line.back() == '\r') line.pop_back();
    header.end = end + 1;
    if (line == "end_header") return header;
    if (!take(line, header)) return std::nullopt;
  }
  return std::nullopt;
}

/// Reads number after number; empty at the end of the content or if there is no number.
class Numbers {
public:
  Numbers(const std::string& content, const Header& header)
      : content_(content), format_(header.format), place_(header.end)
  {
  }

  std::optional<double> next(Type type)
  {
    if (format_ == Format::text) return nextText();
    if (content_.size() - place_ < type.bytes) return std::nullopt;
    std::uint64_t bits = 0;
    for (std::size_t k = 0; k < type.bytes; ++k) {
      const std::size_t at = format_ == Format::littleEndian ? type.bytes - 1 - k : k;
      bits = (bits << 8) | static_cast<unsigned char>(content_[place_ + at]);
    }
    place_ += type.bytes;
    if (type.kind == 'f')
      return type.bytes == 8
                 ? std::bit_cast<double>(bits)
                 : static_cast<double>(std::bit_cast<float>(static_cast<std::uint32_t>(bits)));
    const std::uint64_t sign = std::uint64_t{1} << (8 * type.bytes - 1);
    const auto value = static_cast<double>(bits);
    return type.kind == 'i' && (bits & sign) != 0 ? value - 2.0 * static_cast<double>(sign) : value;
  }

private:
  std::optional<double> nextText()
  {
    while (place_ < content_.size() && std::strchr(" \t\r\n", content_[place_]) != nullptr)
      ++place_;
    double value = 0.0;
    const char* const last = content_.data() + content_.size();
    const auto [end, error] = std::from_chars(content_.data() + place_, last, value);
    if (error != std::errc{}) return std::nullopt;
    place_ = static_cast<std::size_t>(end - content_.data());
    return value;
  }

  const std::string& content_;
  Format format_;
  std::size_t place_;
};

/// Adds one polygon as a triangle fan; false if the corners are invalid.
bool addPolygon(const std::vector<double>& corners, anatomy::Surface& surface)
{
  const auto count = static_cast<double>(surface.points.size());
  for (const double corner : corners)
    if (!(corner >= 0.0 && corner < count) || corner != std::floor(corner)) return false;
  for (std::size_t k = 2; k < corners.size(); ++k)
    surface.triangles.push_back({static_cast<int>(corners[0]), static_cast<int>(corners[k - 1]),
                                 static_cast<int>(corners[k])});
  return true;
}

}  // namespace

std::optional<anatomy::Surface> readPly(const std::string& content)
{
  const auto header = readHeader(content);
  if (!header) return std::nullopt;
  Numbers numbers(content, *header);
  anatomy::Surface surface;
  std::vector<double> list;
  for (const Element& element : header->elements) {
    if (element.properties.empty()) continue;
    for (std::size_t i = 0; i < element.count; ++i) {
      std::array<double, 3> point{};
      for (const Property& property : element.properties) {
        list.clear();
        const auto first = numbers.next(property.count.value_or(property.type));
        if (!first) return std::nullopt;
        if (!property.count) {
          const std::size_t axis = std::string("xyz").find(property.name);
          if (property.name.size() == 1 && axis < 3) point[axis] = 1e-3 * *first;
          continue;
        }
        for (double k = 0.0; k < *first; k += 1.0) {
          const auto entry = numbers.next(property.type);
          if (!entry) return std::nullopt;
          list.push_back(*entry);
        }
        const bool isPolygon = property.name == "vertex_indices" || property.name == "vertex_index";
        if (element.name == "face" && isPolygon && !addPolygon(list, surface)) return std::nullopt;
      }
      if (element.name == "vertex") surface.points.push_back(point);
    }
  }
  if (surface.triangles.empty()) return std::nullopt;
  return surface;
}

}  // namespace perilymph::imaging
