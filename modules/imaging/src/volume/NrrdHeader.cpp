// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "../statements/VolumePairs.h"
#include "HeaderText.h"
#include "VolumeFile.h"
#include "VolumeGeometry.h"
#include "perilymph/foundation/Choice.h"

namespace perilymph::imaging {
namespace {

/// Signs that turn the file's space into LPS; none for a space without left and right.
std::optional<Eigen::Vector3d> signsOf(const std::string& space)
{
  if (space == "left-posterior-superior" || space == "lps") return Eigen::Vector3d(1, 1, 1);
  if (space == "right-anterior-superior" || space == "ras") return Eigen::Vector3d(-1, -1, 1);
  if (space == "left-anterior-superior" || space == "las") return Eigen::Vector3d(1, -1, 1);
  return std::nullopt;
}

std::optional<VoxelType> nrrdType(const std::string& name)
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

/// Keys of the user, by name in lower case without blanks and bars.
using Keys = std::map<std::string, std::string>;

/// Adds a line's field; false if it is none or contradicts an earlier one.
bool addLine(const std::string& line, const std::string& subject, HeaderFields& fields, Keys& keys)
{
  const std::size_t field = line.find(": "), pair = line.find(":=");
  // key:=value pairs are the user's
  const bool isPair = pair != std::string::npos && (field == std::string::npos || pair < field);
  if (line.empty() || line.starts_with('#') || line.starts_with("NRRD000")) return true;
  if (isPair) {
    std::string key = lowerCase(line.substr(0, pair));
    std::erase_if(key, [](char c) { return c == ' ' || c == '\t' || c == '_' || c == '|'; });
    keys.insert_or_assign(key, trimmed(line.substr(pair + 2)));
    return true;
  }
  if (field == std::string::npos) {
    fields.conflict = Sentence{
        "%1 is damaged: a line of its header is no field. Copy or export it again.", subject};
    return false;
  }
  return fields.add(line.substr(0, field), line.substr(field + 2), subject, nrrd::field);
}

bool areEqual(const std::vector<double>& a, const std::vector<double>& b)
{
  return !a.empty() && std::equal(a.begin(), a.end(), b.begin(), b.end(), [](double x, double y) {
    return std::fabs(x - y) <= sizeTolerance * std::max(std::fabs(x), std::fabs(y));
  });
}

/// Keys of the user that name the geometry state it a second time: they must agree with its field.
/// Without one, those of spacing, thickness and unit take its place and are compared with the
/// others.
void addKeys(const Keys& keys, const std::string& subject, HeaderFields& fields)
{
  static const std::map<std::string, const char*> geometry = {
      {"spacing", "spacings"},        {"spacings", "spacings"},
      {"thickness", "thicknesses"},   {"thicknesses", "thicknesses"},
      {"spaceunits", "spaceunits"},   {"sizes", "sizes"},
      {"spaceorigin", "spaceorigin"}, {"spacedirections", "spacedirections"}};
  for (const auto& [key, value] : keys) {
    if (key == "modality" || key.ends_with("00080060modality") || key.ends_with("00080060"))
      fields.modality = value;
    const auto known = geometry.find(key);
    if (known == geometry.end()) continue;
    const std::string field = known->second;
    HeaderFields stated;
    stated.add(field, value, subject, nrrd::keyValue);
    const bool isOptional = field == "spacings" || field == "thicknesses" || field == "spaceunits";
    if (!fields.has(field) && !isOptional) continue;
    if (fields.has(field) && areEqual(fields.numbers(field), stated.numbers(field))) continue;
    if (!fields.add(field, value, subject, nrrd::keyValue)) return;
  }
}

/// The fields of the header; none where there is no whole header. A detached one ends with the file,
/// or an empty line.
std::optional<HeaderFields> nrrdFields(const std::filesystem::path& file)
{
  const std::string content = headOf(file);
  if (content.rfind("NRRD000", 0) != 0) return std::nullopt;
  HeaderFields fields;
  Keys keys;
  bool isWhole = false, isFine = true;
  while (const auto line = lineAt(content, fields.end)) {
    fields.end = line->end;
    isWhole = line->text.empty();
    isFine = isWhole || addLine(line->text, file.string(), fields, keys);
    if (isWhole || !isFine) break;
  }
  if (!isWhole && isFine) {
    isFine = addLine(content.substr(fields.end), file.string(), fields, keys);
    fields.end = content.size();
    if (!fields.has("datafile")) return std::nullopt;
  }
  if (isFine) addKeys(keys, file.string(), fields);
  return fields;
}

/// Sentences of an NRRD's refusal.
class NrrdRefusal {
public:
  explicit NrrdRefusal(const std::filesystem::path& file) : name_(file.string()) {}
  Error operator()(const Sentence& why) const
  {
    return Error{"%1 %2 Export the CT as NRRD with its voxels in the file.", name_, why};
  }

private:
  std::string name_;
};

/// Millimeters of the unit of each direction in space, as the header states them.
struct Units {
  Eigen::Vector3d millimeters = Eigen::Vector3d::Ones();
  Sentence text{"not stated and taken as the millimeter"};
};

Result<Units> unitsOf(const HeaderFields& fields, const std::string& name)
{
  Units units;
  for (const char* const field : {"spaceunits", "units"}) {
    const auto words = wordsOf(fields.text(field));
    if (words.empty()) continue;
    Eigen::Vector3d found = Eigen::Vector3d::Ones();
    for (std::size_t axis = 0; axis < words.size(); ++axis) {
      if (words[axis].empty() || words[axis] == "???") continue;
      const auto millimeters = millimetersOf(words[axis]);
      if (!millimeters || words.size() != 3)
        return Error{
            "%1 states its unit of length as %2; millimeters, centimeters, meters and micrometers "
            "are read, one for each of three axes. Export it again in millimeters.",
            name, fields.text(field)};
      found[static_cast<Eigen::Index>(axis)] = *millimeters;
    }
    if (fields.has("spaceunits") && std::string(field) == "units" && found != units.millimeters)
      return Error{*disagreement(name, nrrd::unit, fields.text("spaceunits"), fields.text(field))};
    units.millimeters = found;
    units.text =
        fields.text(field) + " (" + (std::string(field) == "units" ? field : "space units") + ")";
  }
  return units;
}

/// Refuses numbers per axis that state another voxel size than the directions; a NaN states none.
Result<void> checkSpacings(const HeaderFields& fields, const std::string& name,
                           const Eigen::Vector3d& lengths, VolumeFile& volume,
                           const Eigen::Vector3d& unit_mm)
{
  const std::vector<double> spacings = fields.numbers("spacings"),
                            mins = fields.numbers("axismins"), maxs = fields.numbers("axismaxs"),
                            thicknesses = fields.numbers("thicknesses");
  for (const auto& [field, numbers] :
       {std::pair("spacings", spacings), std::pair("axismins", mins), std::pair("axismaxs", maxs),
        std::pair("thicknesses", thicknesses)})
    if (fields.has(field) && numbers.size() != 3)
      return Error{
          "%1 has a field '%2' that is not one number for each of its three axes: '%3'. Export it "
          "again.",
          name, field, fields.text(field)};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto a = static_cast<Eigen::Index>(axis);
    if (!spacings.empty() && !std::isnan(spacings[axis]))
      if (const auto differs = disagreement(name, nrrd::voxelSize, lengths[a],
                                            unit_mm[a] * std::fabs(spacings[axis]), alongAxis(a)))
        return Error{*differs};
    if (!thicknesses.empty() && !std::isnan(thicknesses[axis]))
      if (const auto differs =
              disagreement(Sentence{"The file"}, nrrd::thickness, lengths[a],
                           unit_mm[a] * std::fabs(thicknesses[axis]), alongAxis(a)))
        volume.warnings.push_back(*differs);
    if (mins.empty() || maxs.empty() || std::isnan(mins[axis]) || std::isnan(maxs[axis])) continue;
    // from center to center, or from edge to edge
    const double extent = unit_mm[a] * std::fabs(maxs[axis] - mins[axis]);
    const auto node = disagreement(name, nrrd::extent, lengths[a], extent / (volume.size[axis] - 1),
                                   alongAxis(a));
    if (node && disagreement(name, nrrd::extent, lengths[a], extent / volume.size[axis]))
      return Error{*node};
  }
  return {};
}

Result<void> nrrdMatrix(const HeaderFields& fields, const std::filesystem::path& file,
                        VolumeFile& volume)
{
  const NrrdRefusal refuse(file);
  const std::string name = file.string();
  const auto signs = signsOf(fields.word("space"));
  const std::vector<double> directions = fields.numbers("spacedirections");
  const std::vector<double> origin = fields.numbers("spaceorigin");
  if (!signs || directions.size() != 9 || origin.size() != 3)
    return refuse(Sentence{
        "has no space, directions and origin in the patient, so left and right are not known."});
  if (fields.has("spacedimension"))
    if (const auto differs =
            disagreement(name, nrrd::dimensions, "3", fields.text("spacedimension")))
      return Error{*differs};
  const auto units = unitsOf(fields, name);
  if (!units) return units.error();
  for (std::size_t row = 0; row < 3; ++row) {
    const auto r = static_cast<Eigen::Index>(row);
    const double scale = (*signs)[r] * units->millimeters[r];
    for (std::size_t axis = 0; axis < 3; ++axis)
      volume.lps_PI(r, static_cast<Eigen::Index>(axis)) = scale * directions[3 * axis + row];
    volume.lps_PI(r, 3) = scale * origin[row];
  }
  if (const auto done = checkVoxels(file, volume.lps_PI, units->text); !done) return done;
  const Eigen::Vector3d lengths = volume.lps_PI.topLeftCorner<3, 3>().colwise().norm().transpose();
  return checkSpacings(fields, name, lengths, volume, units->millimeters);
}

Result<void> nrrdSize(const HeaderFields& fields, const std::filesystem::path& file,
                      VolumeFile& volume)
{
  const NrrdRefusal refuse(file);
  const std::vector<double> sizes = fields.numbers("sizes");
  if (fields.text("dimension") != "3" || sizes.size() != 3)
    return refuse(Sentence{"holds no volume of three dimensions."});
  if (const auto done = checkVolumeSize(file, {sizes[0], sizes[1], sizes[2]}); !done) return done;
  for (std::size_t axis = 0; axis < 3; ++axis) volume.size[axis] = static_cast<int>(sizes[axis]);
  if (fields.has("number")) {
    const std::vector<double> number = fields.numbers("number");
    if (const auto differs =
            disagreement(file.string(), nrrd::voxelCount, sizes[0] * sizes[1] * sizes[2],
                         number.size() == 1 ? number[0] : std::numeric_limits<double>::quiet_NaN()))
      return Error{*differs};
  }
  if (const std::string modality = lowerCase(fields.modality);
      !modality.empty() && modality != "ct" && modality != "ot" && modality != "xa")
    return refuse(Sentence{"is of the modality %1, not CT.", fields.modality});
  for (const std::string& kind : wordsOf(fields.word("kinds")))
    if (kind != "domain" && kind != "space" && kind != "none" && kind != "???")
      return refuse(Sentence{"has an axis of the kind '%1', which is none in space.", kind});
  return {};
}

/// Where the voxels are: behind the header, or in the file that it names.
Result<void> nrrdVoxelPlace(const HeaderFields& fields, const std::filesystem::path& file,
                            VolumeFile& volume)
{
  const NrrdRefusal refuse(file);
  volume.voxelFile = file;
  volume.from = fields.end;
  if (fields.has("datafile")) {
    const auto beside = besideHeader(file, fields.text("datafile"));
    if (!beside || fields.word("datafile").starts_with("list") ||
        fields.text("datafile").find('%') != std::string::npos)
      return refuse(
          Sentence{"keeps its voxels in '%1'; they are read from one file in the header's folder.",
                   fields.text("datafile")});
    volume.voxelFile = *beside;
    volume.from = 0;
  }
  const std::string encoding = fields.word("encoding");
  if (encoding == "gzip" || encoding == "gz")
    volume.packing = Packing::required;
  else if (encoding != "raw")
    return refuse(Sentence{"is encoded as '%1'; raw and gzip are read.", encoding});
  // 0 skips nothing; lines and what is counted from the end are rare and ambiguous
  const std::vector<double> lines = fields.numbers("lineskip"), bytes = fields.numbers("byteskip");
  const auto isWrong = [&fields](const char* field, const std::vector<double>& numbers,
                                 double largest) {
    return fields.has(field) && (numbers.size() != 1 || !(numbers[0] >= 0.0) ||
                                 numbers[0] > largest || numbers[0] != std::floor(numbers[0]));
  };
  if (isWrong("lineskip", lines, 0.0) || isWrong("byteskip", bytes, 1e9))
    return refuse(Sentence{"skips a part of its voxels."});
  if (!bytes.empty()) volume.skipped = static_cast<std::size_t>(bytes[0]);
  return {};
}

}  // namespace

Result<VolumeFile> readNrrdHeader(const std::filesystem::path& file)
{
  VolumeFile volume;
  volume.format = "NRRD";
  volume.bytes = &nrrd::bytes;
  const NrrdRefusal refuse(file);
  const auto fields = nrrdFields(file);
  if (!fields) return refuse(Sentence{"is no NRRD file with a whole header."});
  if (!fields->conflict.empty()) return Error{fields->conflict};
  if (const auto done = nrrdSize(*fields, file, volume); !done) return done.error();
  const auto type = nrrdType(fields->word("type"));
  if (!type) return refuse(Sentence{"holds voxels that are no gray values."});
  volume.coding.type = *type;
  static constexpr std::array orders{Choice<bool>{false, "little"}, Choice<bool>{true, "big"}};
  const auto isBigEndian = valueIn(orders, fields->word("endian"));
  if (bytesOf(*type) > 1 && !isBigEndian)
    return refuse(Sentence{"does not say the order of its bytes."});
  volume.coding.isBigEndian = isBigEndian.value_or(false);
  if (const auto done = nrrdMatrix(*fields, file, volume); !done) return done.error();
  if (const auto done = nrrdVoxelPlace(*fields, file, volume); !done) return done.error();
  if (fields->has("oldmin") || fields->has("oldmax"))
    volume.warnings.push_back(
        *disagreement(Sentence{"The file"}, nrrd::grayValues, Sentence{"as stored"},
                      "'" + fields->text("oldmin") + "' to '" + fields->text("oldmax") + "'"));
  if (const auto done = checkDataLength(file, volume); !done) return done.error();
  return volume;
}

}  // namespace perilymph::imaging
