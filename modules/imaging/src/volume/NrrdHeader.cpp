// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cctype>
#include <charconv>
#include <fstream>
#include <map>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "VolumeFile.h"

namespace perilymph::imaging {
namespace {

constexpr std::size_t maxHeader = 1u << 16;

std::string lower(std::string text)
{
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

/// Numbers of a text between parentheses and commas; none where a word is no number.
std::vector<double> numbersIn(const std::string& text)
{
  std::vector<double> numbers;
  std::string spaced = text;
  for (char& c : spaced)
    if (c == '(' || c == ')' || c == ',') c = ' ';
  std::istringstream words(spaced);
  for (std::string word; words >> word;) {
    double number = 0.0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
    if (error != std::errc{} || end != word.data() + word.size()) return {};
    numbers.push_back(number);
  }
  return numbers;
}

/// Signs that turn the file's space into LPS; none for a space without left and right.
std::optional<Eigen::Vector3d> signsOf(const std::string& space)
{
  if (space == "left-posterior-superior" || space == "lps") return Eigen::Vector3d(1, 1, 1);
  if (space == "right-anterior-superior" || space == "ras") return Eigen::Vector3d(-1, -1, 1);
  if (space == "left-anterior-superior" || space == "las") return Eigen::Vector3d(1, -1, 1);
  return std::nullopt;
}

std::optional<VoxelType> typeOf(const std::string& name)
{
  static const std::map<std::string, VoxelType> types = {
      {"signed char", VoxelType::int8},    {"int8", VoxelType::int8},
      {"int8_t", VoxelType::int8},         {"uchar", VoxelType::uint8},
      {"unsigned char", VoxelType::uint8}, {"uint8", VoxelType::uint8},
      {"uint8_t", VoxelType::uint8},       {"short", VoxelType::int16},
      {"short int", VoxelType::int16},     {"signed short", VoxelType::int16},
      {"int16", VoxelType::int16},         {"int16_t", VoxelType::int16},
      {"ushort", VoxelType::uint16},       {"unsigned short", VoxelType::uint16},
      {"uint16", VoxelType::uint16},       {"uint16_t", VoxelType::uint16},
      {"int", VoxelType::int32},           {"signed int", VoxelType::int32},
      {"int32", VoxelType::int32},         {"int32_t", VoxelType::int32},
      {"uint", VoxelType::uint32},         {"unsigned int", VoxelType::uint32},
      {"uint32", VoxelType::uint32},       {"uint32_t", VoxelType::uint32},
      {"float", VoxelType::float32},       {"double", VoxelType::float64}};
  const auto found = types.find(name);
  if (found == types.end()) return std::nullopt;
  return found->second;
}

using Fields = std::map<std::string, std::string>;

/// The fields of the header, and where the voxels begin; empty where there is no whole header.
Fields fieldsOf(const std::filesystem::path& file, std::size_t& end)
{
  std::ifstream stream(file, std::ios::binary);
  std::string content(maxHeader, '\0');
  stream.read(content.data(), static_cast<std::streamsize>(content.size()));
  content.resize(static_cast<std::size_t>(stream.gcount()));
  if (content.rfind("NRRD000", 0) != 0) return {};
  Fields fields;
  for (std::size_t start = 0; start < content.size();) {
    const std::size_t stop = content.find('\n', start);
    if (stop == std::string::npos) return {};
    std::string line = content.substr(start, stop - start);
    if (!line.empty() && line.back() == '\r') line.pop_back();
    start = stop + 1;
    if (line.empty()) {
      end = start;
      return fields;
    }
    const std::size_t colon = line.find(": ");
    if (line[0] != '#' && colon != std::string::npos && line.find(":=") == std::string::npos)
      fields[lower(line.substr(0, colon))] = line.substr(colon + 2);
  }
  return {};
}

}  // namespace

Result<VolumeFile> readNrrdHeader(const std::filesystem::path& file)
{
  VolumeFile volume;
  volume.format = "NRRD";
  Fields fields = fieldsOf(file, volume.firstByte);
  const auto refuse = [&file](const std::string& why) {
    return Error{file.string() + " " + why + " Export the CT as NRRD with its voxels in the file."};
  };
  if (fields.empty()) return refuse("is no NRRD file with a whole header.");
  if (fields.contains("data file") || fields.contains("datafile"))
    return refuse("keeps its voxels in another file.");
  const std::vector<double> sizes = numbersIn(fields["sizes"]);
  if (fields["dimension"] != "3" || sizes.size() != 3)
    return refuse("holds no volume of three dimensions.");
  if (const auto done = checkVolumeSize(file, {sizes[0], sizes[1], sizes[2]}); !done)
    return done.error();
  for (std::size_t axis = 0; axis < 3; ++axis) volume.size[axis] = static_cast<int>(sizes[axis]);
  const auto type = typeOf(lower(fields["type"]));
  if (!type) return refuse("holds voxels that are no gray values.");
  volume.type = *type;
  const std::string endian = lower(fields["endian"]);
  if (bytesOf(*type) > 1 && endian != "little" && endian != "big")
    return refuse("does not say the order of its bytes.");
  volume.isBigEndian = endian == "big";

  const auto signs = signsOf(lower(fields["space"]));
  const std::vector<double> directions = numbersIn(fields["space directions"]);
  const std::vector<double> origin = numbersIn(fields["space origin"]);
  if (!signs || directions.size() != 9 || origin.size() != 3)
    return refuse(
        "has no space, directions and origin in the patient, so left and right are not known.");
  for (std::size_t row = 0; row < 3; ++row) {
    const auto r = static_cast<Eigen::Index>(row);
    for (std::size_t axis = 0; axis < 3; ++axis)
      volume.lps_PI(r, static_cast<Eigen::Index>(axis)) = (*signs)[r] * directions[3 * axis + row];
    volume.lps_PI(r, 3) = (*signs)[r] * origin[row];
  }

  const std::string encoding = lower(fields["encoding"]);
  if (encoding == "gzip" || encoding == "gz") {
    volume.packedFrom = volume.firstByte;
    volume.firstByte = 0;
  } else if (encoding != "raw") {
    return refuse("is encoded as '" + encoding + "'; raw and gzip are read.");
  }
  if (fields.contains("line skip") || fields.contains("byte skip"))
    return refuse("skips a part of its voxels.");
  return volume;
}

}  // namespace perilymph::imaging
