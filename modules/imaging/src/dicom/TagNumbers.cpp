// SPDX-License-Identifier: BSD-3-Clause
#include "TagNumbers.h"

#include <vtkDICOMDictionary.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>

namespace perilymph::imaging {
namespace {

constexpr std::size_t maxShown = 40;
constexpr std::size_t maxFaults = 16;  // of one file; the first is shown

std::string_view withoutBlanks(std::string_view text)
{
  const std::string_view blanks(" \0", 2);
  const auto first = text.find_first_not_of(blanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

/// The representation of a value; where it is stated as unknown, that of the dictionary.
vtkDICOMVR representation(const vtkDICOMValue& value, vtkDICOMTag tag)
{
  const vtkDICOMVR own = value.GetVR();
  if (own != vtkDICOMVR::UN) return own;
  return vtkDICOMDictionary::FindDictEntry(tag).GetVR();
}

bool isBinary(vtkDICOMVR type)
{
  for (const auto binary : {vtkDICOMVR::US, vtkDICOMVR::SS, vtkDICOMVR::UL, vtkDICOMVR::SL,
                            vtkDICOMVR::FL, vtkDICOMVR::FD, vtkDICOMVR::XS})
    if (type == binary) return true;
  return false;
}

/// The text of a value, whatever its representation.
std::string textOf(const vtkDICOMValue& value)
{
  const std::size_t bytes = value.GetVL();
  if (const char* const text = value.GetCharData()) return {text, bytes};
  if (const unsigned char* const text = value.GetUnsignedCharData())
    return {reinterpret_cast<const char*>(text), bytes};
  return {};
}

/// Text for a message: printable, short.
std::string shown(std::string text)
{
  if (text.size() > maxShown) text = text.substr(0, maxShown) + "...";
  for (char& c : text)
    if (c < ' ' || c > '~' || c == '"') c = '?';
  return "\"" + text + "\"";
}

/// Numbers of a binary value of an unknown representation: 16 bits in little-endian order.
Eigen::VectorXd wordsIn(const std::string& bytes, bool isSigned)
{
  Eigen::VectorXd numbers(static_cast<Eigen::Index>(bytes.size() / 2));
  for (Eigen::Index i = 0; i < numbers.size(); ++i) {
    const auto low = static_cast<unsigned char>(bytes[static_cast<std::size_t>(2 * i)]);
    const auto high = static_cast<unsigned char>(bytes[static_cast<std::size_t>(2 * i + 1)]);
    const auto word = static_cast<std::uint16_t>(low | high << 8);
    numbers[i] = isSigned ? static_cast<double>(static_cast<std::int16_t>(word)) : word;
  }
  return numbers;
}

}  // namespace

std::optional<double> decimalNumber(std::string_view text)
{
  text = withoutBlanks(text);
  if (text.starts_with('+')) {
    text.remove_prefix(1);
    if (text.starts_with('-')) return std::nullopt;
  }
  double number = 0.0;
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, number, std::chars_format::general);
  if (text.empty() || error != std::errc{} || stop != end || !std::isfinite(number))
    return std::nullopt;
  return number;
}

std::string nameOf(vtkDICOMTag tag)
{
  const vtkDICOMDictEntry entry = vtkDICOMDictionary::FindDictEntry(tag);
  char text[16];
  std::snprintf(text, sizeof text, "(%04X,%04X)", tag.GetGroup(), tag.GetElement());
  return (entry.IsValid() ? std::string(entry.GetName()) + " " : std::string()) + text;
}

void TagNumbers::note(vtkDICOMTag tag, const std::string& text, const Sentence& expected)
{
  Sentence clause{"%1 as %2, where %3", nameOf(tag), shown(text), expected};
  if (faults_.size() < maxFaults &&
      std::find(faults_.begin(), faults_.end(), clause) == faults_.end())
    faults_.push_back(std::move(clause));
}

std::optional<Eigen::VectorXd> TagNumbers::read(const vtkDICOMValue& value, vtkDICOMTag tag,
                                                std::size_t count)
{
  if (!value.IsValid() || value.GetVL() == 0) return std::nullopt;
  const Sentence expected =
      count == 1 ? Sentence{"one number belongs"} : Sentence{"%1 numbers belong", count};
  const vtkDICOMVR type = representation(value, tag);
  Eigen::VectorXd numbers;
  std::string text;
  if (isBinary(type) && value.GetVR() == vtkDICOMVR::UN) {
    numbers = wordsIn(textOf(value), type == vtkDICOMVR::SS);
  } else if (isBinary(type)) {
    numbers.resize(static_cast<Eigen::Index>(value.GetNumberOfValues()));
    for (Eigen::Index i = 0; i < numbers.size(); ++i)
      numbers[i] = value.GetDouble(static_cast<std::size_t>(i));
  } else {
    text = textOf(value);
    if (!text.empty() && withoutBlanks(text).empty()) return std::nullopt;
    std::vector<double> found;
    std::string_view rest = text;
    for (bool isMore = true; isMore;) {
      const auto end = rest.find('\\');
      isMore = end != std::string_view::npos;
      const auto number = decimalNumber(rest.substr(0, end));
      if (!number) {
        note(tag, text, expected);
        return std::nullopt;
      }
      found.push_back(*number);
      if (isMore) rest.remove_prefix(end + 1);
    }
    numbers = Eigen::Map<Eigen::VectorXd>(found.data(), static_cast<Eigen::Index>(found.size()));
  }
  if (static_cast<std::size_t>(numbers.size()) == count && numbers.allFinite()) return numbers;
  if (text.empty()) text = std::to_string(numbers.size()) + " binary numbers";
  note(tag, text, expected);
  return std::nullopt;
}

std::optional<double> TagNumbers::read(const vtkDICOMValue& value, vtkDICOMTag tag)
{
  const auto numbers = read(value, tag, 1);
  if (!numbers) return std::nullopt;
  return (*numbers)[0];
}

std::optional<int> TagNumbers::readWhole(const vtkDICOMValue& value, vtkDICOMTag tag, int minimum,
                                         int maximum)
{
  const auto number = read(value, tag);
  if (!number) return std::nullopt;
  if (*number == std::floor(*number) && *number >= minimum && *number <= maximum)
    return static_cast<int>(*number);
  char text[32];
  std::snprintf(text, sizeof text, "%.10g", *number);
  note(tag, text, Sentence{"a whole number from %1 to %2 belongs", minimum, maximum});
  return std::nullopt;
}

}  // namespace perilymph::imaging
