// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "../statements/VolumePairs.h"
#include "HeaderText.h"
#include "VolumeFile.h"
#include "VolumeGeometry.h"

namespace perilymph::imaging {
namespace {

/// Names that older programs give a field.
std::string currentName(const std::string& name)
{
  static const std::map<std::string, std::string> aliases = {
      {"rotation", "transformmatrix"},
      {"orientation", "transformmatrix"},
      {"position", "offset"},
      {"origin", "offset"},
      {"elementbyteordermsb", "byteordermsb"},
      {"binarydatabyteordermsb", "byteordermsb"}};
  const auto found = aliases.find(lowerCase(trimmed(name)));
  return found == aliases.end() ? name : found->second;
}

/// The fields up to ElementDataFile, behind which the voxels begin; none where that is missing.
std::optional<HeaderFields> metaFields(const std::filesystem::path& file)
{
  std::string content = headOf(file);
  // the last line of a header of its own may have no end
  if (!content.empty() && content.size() < 4096 && content.back() != '\n') content += '\n';
  HeaderFields fields;
  while (const auto line = lineAt(content, fields.end)) {
    fields.end = line->end;
    const std::size_t equals = line->text.find('=');
    if (equals == std::string::npos) {
      if (trimmed(line->text).empty()) continue;
      return std::nullopt;
    }
    const std::string name = currentName(line->text.substr(0, equals));
    if (!fields.add(name, line->text.substr(equals + 1), file.string(), meta::field)) return fields;
    if (fields.has("elementdatafile")) return fields;
  }
  return std::nullopt;
}

std::optional<VoxelType> metaType(const std::string& name)
{
  static const std::map<std::string, VoxelType> types = {
      {"met_char", VoxelType::int8},     {"met_uchar", VoxelType::uint8},
      {"met_short", VoxelType::int16},   {"met_ushort", VoxelType::uint16},
      {"met_int", VoxelType::int32},     {"met_uint", VoxelType::uint32},
      {"met_float", VoxelType::float32}, {"met_double", VoxelType::float64}};
  const auto found = types.find(name);
  if (found == types.end()) return std::nullopt;
  return found->second;
}

Error refuseMeta(const std::filesystem::path& file, const Sentence& why)
{
  return Error{"%1 %2 Export the CT as MetaImage (.mha) or NRRD.", file, why};
}

/// Where each axis points to, by the letters of where it comes from: R is from right to left.
Result<void> checkLetters(const HeaderFields& fields, const std::string& name,
                          const Eigen::Matrix3d& axes)
{
  const std::string letters = fields.text("anatomicalorientation");
  if (letters.empty() || letters.find('?') != std::string::npos) return {};
  // a letter holds for directions up to about 55 degrees from it
  constexpr double minCosine = 0.3;
  constexpr const char* froms = "RAILPS";
  std::string found;
  bool agrees = letters.size() == 3;
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    Eigen::Index nearest = 0;
    axes.col(axis).cwiseAbs().maxCoeff(&nearest);
    found += froms[nearest + (axes(nearest, axis) < 0.0 ? 3 : 0)];
    if (!agrees) continue;
    const char* const letter = std::strchr(froms, letters[static_cast<std::size_t>(axis)]);
    if (!letter) {
      agrees = false;
      continue;
    }
    const std::ptrdiff_t at = letter - froms;
    agrees = (at < 3 ? 1.0 : -1.0) * axes(at % 3, axis) > minCosine;
  }
  if (agrees) return {};
  return Error{*disagreement(name, meta::orientation, Sentence{"%1 (near)", found}, letters)};
}

Result<void> metaMatrix(const HeaderFields& fields, const std::filesystem::path& file,
                        VolumeFile& volume)
{
  const std::string name = file.string();
  const auto matrix = fields.numbers("transformmatrix"), offset = fields.numbers("offset"),
             spacing =
                 fields.numbers(fields.has("elementspacing") ? "elementspacing" : "elementsize"),
             sizes = fields.numbers("elementsize");
  if (matrix.size() != 9 || offset.size() != 3 || spacing.size() != 3)
    return refuseMeta(
        file,
        Sentence{"has no TransformMatrix, Offset and ElementSpacing of three dimensions, so left "
                 "and right or its voxel size are not known."});
  double unit_mm = 1.0;
  Sentence unit{"not stated and taken as the millimeter"};
  if (fields.has("distanceunits") && fields.text("distanceunits") != "?") {
    const auto stated = millimetersOf(fields.text("distanceunits"));
    if (!stated)
      return Error{
          "%1 states its unit of length as %2; millimeters, centimeters, meters and micrometers "
          "are read, one for each of three axes. Export it again in millimeters.",
          name, fields.text("distanceunits")};
    unit_mm = *stated;
    unit = fields.text("distanceunits") + " (DistanceUnits)";
  }
  Eigen::Matrix3d axes;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto a = static_cast<Eigen::Index>(axis);
    for (std::size_t row = 0; row < 3; ++row)
      axes(static_cast<Eigen::Index>(row), a) = matrix[3 * axis + row];
    volume.lps_PI(a, 3) = unit_mm * offset[axis];
    const double length_mm = unit_mm * spacing[axis];
    if (const auto differs = disagreement(name, meta::voxelSize, length_mm,
                                          length_mm * axes.col(a).norm(), alongAxis(a)))
      return Error{*differs};
    if (fields.has("elementsize"))
      if (const auto differs = disagreement(
              name, meta::elementSize, length_mm,
              sizes.size() == 3 ? unit_mm * sizes[axis] : std::numeric_limits<double>::quiet_NaN(),
              alongAxis(a)))
        return Error{*differs};
    volume.lps_PI.block<3, 1>(0, a) = length_mm * axes.col(a);
  }
  if (const auto done = checkVoxels(file, volume.lps_PI, unit); !done) return done;
  return checkLetters(fields, name, axes);
}

Result<void> metaSize(const HeaderFields& fields, const std::filesystem::path& file,
                      VolumeFile& volume)
{
  const std::vector<double> sizes = fields.numbers("dimsize");
  const bool isVolume = fields.word("objecttype").empty() || fields.word("objecttype") == "image";
  if (!isVolume || fields.text("ndims") != "3" || sizes.size() != 3)
    return refuseMeta(file, Sentence{"holds no volume of three dimensions."});
  if (fields.has("elementnumberofchannels") && fields.text("elementnumberofchannels") != "1")
    return refuseMeta(file, Sentence{"holds voxels that are no gray values."});
  if (const auto done = checkVolumeSize(file, {sizes[0], sizes[1], sizes[2]}); !done) return done;
  for (std::size_t axis = 0; axis < 3; ++axis) volume.size[axis] = static_cast<int>(sizes[axis]);
  const std::string modality = fields.text("modality");
  if (!modality.empty() && modality != "MET_MOD_CT" && modality != "MET_MOD_OTHER" &&
      modality != "MET_MOD_UNKNOWN")
    return refuseMeta(file, Sentence{"is of the modality %1, not CT.", modality});
  return {};
}

/// True or false as programs write it; none for other words.
std::optional<bool> truthOf(const std::string& word)
{
  if (word == "true" || word == "t" || word == "1") return true;
  if (word == "false" || word == "f" || word == "0" || word.empty()) return false;
  return std::nullopt;
}

Result<void> metaCoding(const HeaderFields& fields, const std::filesystem::path& file,
                        VolumeFile& volume)
{
  const auto type = metaType(fields.word("elementtype"));
  if (!type) return refuseMeta(file, Sentence{"holds voxels that are no gray values."});
  volume.coding.type = *type;
  const auto isBigEndian = truthOf(fields.word("byteordermsb"));
  const auto isPacked = truthOf(fields.word("compresseddata"));
  const auto isBinary = truthOf(fields.word("binarydata"));
  if (!isBigEndian || !isPacked || !isBinary || (fields.has("binarydata") && !*isBinary))
    return refuseMeta(file,
                      Sentence{"does not hold its voxels as binary numbers in a stated order."});
  volume.coding.isBigEndian = *isBigEndian;
  if (*isPacked) volume.packing = Packing::required;
  for (const auto& [field, same] : {std::pair("elementtointensityfunctionslope", 1.0),
                                    std::pair("elementtointensityfunctionoffset", 0.0)}) {
    const std::vector<double> number = fields.numbers(field);
    if (fields.has(field) && (number.size() != 1 || number[0] != same))
      return refuseMeta(
          file,
          Sentence{"scales its gray values by ElementToIntensityFunction, which programs read "
                   "differently."});
  }
  const auto minimum = fields.numbers("elementmin"), maximum = fields.numbers("elementmax");
  if (minimum.size() == 1 && maximum.size() == 1) volume.grayRange = {minimum[0], maximum[0]};
  return {};
}

Result<void> metaVoxelPlace(const HeaderFields& fields, const std::filesystem::path& file,
                            VolumeFile& volume)
{
  volume.voxelFile = file;
  volume.from = fields.end;
  const std::string named = fields.text("elementdatafile");
  if (named != "LOCAL" && named != "Local" && named != "local") {
    const auto beside = besideHeader(file, named);
    if (!beside || named == "LIST" || named.find('%') != std::string::npos)
      return refuseMeta(
          file,
          Sentence{"keeps its voxels in '%1'; they are read from one file in the header's folder.",
                   named});
    volume.voxelFile = *beside;
    volume.from = 0;
  }
  if (fields.has("headersize")) {
    const std::vector<double> skipped = fields.numbers("headersize");
    if (skipped.size() != 1 || !(skipped[0] >= 0.0 && skipped[0] <= 1e9) ||
        skipped[0] != std::floor(skipped[0]))
      return refuseMeta(file, Sentence{"skips a part of its voxels."});
    volume.from += static_cast<std::size_t>(skipped[0]);
  }
  if (volume.packing == Packing::none || !fields.has("compresseddatasize")) return {};
  const auto source = ByteSource::open(volume.voxelFile, volume.from, Packing::none);
  if (!source) return source.error();
  if (const auto differs = disagreement(file.string(), meta::packedBytes,
                                        std::to_string(source->fileBytes()) + " bytes",
                                        fields.text("compresseddatasize") + " bytes"))
    return Error{*differs};
  return {};
}

}  // namespace

Result<VolumeFile> readMetaHeader(const std::filesystem::path& file)
{
  VolumeFile volume;
  volume.format = "MetaImage";
  volume.bytes = &meta::bytes;
  const auto fields = metaFields(file);
  if (!fields) return refuseMeta(file, Sentence{"is no MetaImage file with a whole header."});
  if (!fields->conflict.empty()) return Error{fields->conflict};
  if (const auto done = metaSize(*fields, file, volume); !done) return done.error();
  if (const auto done = metaCoding(*fields, file, volume); !done) return done.error();
  if (const auto done = metaMatrix(*fields, file, volume); !done) return done.error();
  if (const auto done = metaVoxelPlace(*fields, file, volume); !done) return done.error();
  if (const auto done = checkDataLength(file, volume); !done) return done.error();
  return volume;
}

}  // namespace perilymph::imaging
