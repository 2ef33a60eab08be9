// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Geometry>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "../statements/VolumePairs.h"
#include "VolumeFile.h"
#include "VolumeGeometry.h"

namespace perilymph::imaging {
namespace {

constexpr std::size_t headerBytes = 348;

/// Numbers of the header in the file's byte order.
class Header {
public:
  Header(const std::string& bytes, bool isBigEndian) : bytes_(bytes), isBigEndian_(isBigEndian) {}

  int word(std::size_t at) const { return static_cast<std::int16_t>(bits(at, 2)); }
  double number(std::size_t at) const
  {
    return static_cast<double>(std::bit_cast<float>(static_cast<std::uint32_t>(bits(at, 4))));
  }
  std::uint64_t bits(std::size_t at, std::size_t count) const
  {
    std::uint64_t value = 0;
    for (std::size_t k = 0; k < count; ++k)
      value = (value << 8) |
              static_cast<unsigned char>(bytes_[at + (isBigEndian_ ? k : count - 1 - k)]);
    return value;
  }

private:
  const std::string& bytes_;
  bool isBigEndian_;
};

/// Millimeters of the header's unit of length; none where it is not one.
std::optional<double> unitOf(int code)
{
  switch (code & 7) {
    case 0:  // not said; every program means mm
    case 2:
      return 1.0;
    case 1:
      return 1e3;
    case 3:
      return 1e-3;
    default:
      return std::nullopt;
  }
}

/// The unit of length as the header states it.
Sentence unitText(int code)
{
  switch (code & 7) {
    case 1:
      return Sentence{"the meter (xyzt_units)"};
    case 2:
      return Sentence{"the millimeter (xyzt_units)"};
    case 3:
      return Sentence{"the micrometer (xyzt_units)"};
    default:
      return Sentence{"not stated (xyzt_units) and taken as the millimeter"};
  }
}

using Matrix = Eigen::Matrix4d;

int sformCode(const Header& header) { return header.word(254); }
int qformCode(const Header& header) { return header.word(252); }

/// Codes of a space: 1 the scanner's, 2 that of another scan, 3 and above that of a template.
constexpr int lastCodeOfAScan = 2;

Matrix sformOf(const Header& header)
{
  Matrix ras = Matrix::Identity();
  for (Eigen::Index row = 0; row < 3; ++row)
    for (Eigen::Index column = 0; column < 4; ++column)
      ras(row, column) = header.number(280 + 16 * static_cast<std::size_t>(row) +
                                       4 * static_cast<std::size_t>(column));
  return ras;
}

double pixdim(const Header& header, Eigen::Index axis)
{
  return std::fabs(header.number(80 + 4 * static_cast<std::size_t>(axis)));
}

/// nifti1.h, method 2: a quaternion without its real part, and a handedness; not finite where these
/// are none.
Matrix qformOf(const Header& header)
{
  constexpr double rounding = 1e-3;
  const double b = header.number(256), c = header.number(260), d = header.number(264);
  const double rest = 1.0 - b * b - c * c - d * d;
  const double qfac = header.number(76);
  const bool isSign = qfac == 1.0 || qfac == -1.0 || qfac == 0.0;  // 0 counts as 1
  if (!(rest > -rounding) || !isSign)
    return Matrix::Constant(std::numeric_limits<double>::quiet_NaN());
  const Eigen::Quaterniond turn(rest > 0.0 ? std::sqrt(rest) : 0.0, b, c, d);
  Eigen::Matrix3d axes = turn.normalized().toRotationMatrix();
  for (Eigen::Index axis = 0; axis < 3; ++axis) axes.col(axis) *= pixdim(header, axis);
  if (qfac < 0.0) axes.col(2) = -axes.col(2);
  Matrix ras = Matrix::Identity();
  ras.topLeftCorner<3, 3>() = axes;
  for (Eigen::Index axis = 0; axis < 3; ++axis)
    ras(axis, 3) = header.number(268 + 4 * static_cast<std::size_t>(axis));
  return ras;
}

std::string placeText(const Eigen::Vector4d& place)
{
  std::string text = "(";
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    std::array<char, 40> number{};
    const auto done = std::to_chars(number.data(), number.data() + number.size(), place[axis],
                                    std::chars_format::general, 6);
    text += (axis > 0 ? ", " : "") + std::string(number.data(), done.ptr);
  }
  return text + ") mm";
}

/// The sentence about a corner voxel that two matrices put at different places; empty where both
/// agree at all eight.
std::optional<Sentence> differentPlaces(const Sentence& subject, const StatedTwice& pair,
                                        const std::array<int, 3>& size, const Matrix& first,
                                        const Matrix& second, double unit_mm)
{
  for (int corner = 7; corner >= 0; --corner) {
    const Eigen::Vector4d index((corner & 1) * (size[0] - 1), ((corner >> 1) & 1) * (size[1] - 1),
                                (corner >> 2) * (size[2] - 1), 1.0);
    const Eigen::Vector4d one = first * index, other = second * index;
    if ((one - other).norm() * unit_mm <= pair.absolute) continue;
    return disagreement(subject, pair, placeText(unit_mm * one), placeText(unit_mm * other),
                        Sentence{" (%1, %2, %3)", std::lround(index[0]), std::lround(index[1]),
                                 std::lround(index[2])});
  }
  return std::nullopt;
}

Sentence handText(const Matrix& ras)
{
  return ras.topLeftCorner<3, 3>().determinant() > 0.0 ? Sentence{"right-handed"}
                                                       : Sentence{"left-handed"};
}

/// What a header says of the place of its voxels.
struct Place {
  Matrix ras;  ///< Index to RAS, in the header's unit.
  std::vector<Sentence> warnings;
};

/// The SForm, checked against pixdim and the QForm; or the QForm.
Result<Place> placeOf(const Header& header, const std::string& name, const std::array<int, 3>& size,
                      double unit_mm)
{
  const Matrix sform = sformOf(header), qform = qformOf(header);
  const bool hasS = sformCode(header) > 0, hasQ = qformCode(header) > 0;
  const bool isSUsable = hasS && sform.allFinite() && !sform.topLeftCorner<3, 3>().isZero(0.0);
  const bool isTemplate =
      sformCode(header) > lastCodeOfAScan && qformCode(header) <= lastCodeOfAScan;
  if (hasQ && !qform.allFinite())
    return Error{
        "%1 has a QForm that is no rotation: its quaternion is longer than 1, its pixdim[0] not 1 "
        "or -1, or a number not finite. Export it again.",
        name};
  if (!isSUsable && !hasQ)
    return Error{
        "%1 has neither an SForm nor a QForm in a unit of length, so left and right are not known. "
        "Export it with its orientation.",
        name};
  if (!isSUsable) {
    Place place{qform, {}};
    if (hasS)
      place.warnings.push_back(*disagreement(Sentence{"The file"}, nifti::unusableForm,
                                             "code " + std::to_string(sformCode(header)),
                                             Sentence{"zeros or values that are no numbers"}));
    return place;
  }
  if (hasQ)
    if (const auto differs =
            disagreement(name, nifti::handedness, handText(sform), handText(qform)))
      return Error{*differs};
  if (hasQ && isTemplate) {
    Place place{qform, {}};
    if (const auto differs = differentPlaces(Sentence{"The file"}, nifti::templateSForm, size,
                                             qform, sform, unit_mm))
      place.warnings.push_back(*differs);
    return place;
  }
  for (Eigen::Index axis = 0; axis < 3; ++axis)
    if (const auto differs =
            disagreement(name, nifti::voxelSize, unit_mm * sform.block<3, 1>(0, axis).norm(),
                         unit_mm * pixdim(header, axis), alongAxis(axis)))
      return Error{*differs};
  Place place{sform, {}};
  if (!hasQ) return place;
  const bool isSameSpace = sformCode(header) == qformCode(header);
  const auto differs = differentPlaces(isSameSpace ? Sentence(name) : Sentence{"The file"},
                                       isSameSpace ? nifti::cornerPlace : nifti::otherQForm, size,
                                       sform, qform, unit_mm);
  if (differs && isSameSpace) return Error{*differs};
  if (differs) place.warnings.push_back(*differs);
  return place;
}

/// Slope and intercept: a slope of 0 means that there are none.
Result<void> readScaling(const Header& header, const std::string& name, VolumeFile& volume)
{
  const double slope = header.number(112), intercept = header.number(116);
  if (slope == 0.0 && intercept == 0.0) return {};
  if (slope == 0.0) {
    volume.warnings.push_back(*disagreement(Sentence{"The file"}, nifti::grayValues,
                                            Sentence{"0 (none)"},
                                            std::to_string(std::lround(intercept))));
    return {};
  }
  if (!(slope > 0.0) || !std::isfinite(slope) || !std::isfinite(intercept))
    return Error{
        "%1 has a scl_slope or scl_inter that scales no gray value: the slope must be above 0 and "
        "both finite. Export it again.",
        name};
  volume.coding.slope = slope;
  volume.coding.intercept = intercept;
  return {};
}

Result<void> niftiType(const Header& header, const std::string& name, VolumeFile& volume)
{
  static const std::map<int, VoxelType> types = {
      {2, VoxelType::uint8},    {4, VoxelType::int16},    {8, VoxelType::int32},
      {16, VoxelType::float32}, {64, VoxelType::float64}, {256, VoxelType::int8},
      {512, VoxelType::uint16}, {768, VoxelType::uint32}};
  const auto type = types.find(header.word(70));
  if (type == types.end())
    return Error{
        "%1 holds voxels of the type %2, which are no gray values. Save the CT as 16-bit numbers.",
        name, header.word(70)};
  volume.coding.type = type->second;
  if (const int intent = header.word(68); intent != 0)
    return Error{
        "%1 states by its intent_code %2 that its voxels are labels or statistics and no gray "
        "values. Save the CT itself, with the code 0.",
        name, intent};
  if (const auto differs =
          disagreement(name, nifti::voxelBits, 8.0 * static_cast<double>(bytesOf(type->second)),
                       header.word(72)))
    return Error{*differs};
  return {};
}

Result<void> niftiSize(const Header& header, const std::filesystem::path& file, VolumeFile& volume)
{
  const int dimensions = header.word(40);
  if (dimensions < 3 || dimensions > 7)
    return Error{"%1 holds no volume of three dimensions: its dim[0] is %2. Save the CT alone.",
                 file, dimensions};
  for (int axis = 4; axis <= dimensions; ++axis)
    if (header.word(40 + 2 * static_cast<std::size_t>(axis)) > 1)
      return Error{"%1 holds more than one volume. Save the CT alone.", file};
  const std::array<double, 3> size{1.0 * header.word(42), 1.0 * header.word(44),
                                   1.0 * header.word(46)};
  if (const auto done = checkVolumeSize(file, size); !done) return done;
  for (std::size_t axis = 0; axis < 3; ++axis) volume.size[axis] = static_cast<int>(size[axis]);
  return {};
}

Result<std::string> headerOf(const std::filesystem::path& file)
{
  auto source = ByteSource::open(file, 0, Packing::detected);
  if (!source) return source.error();
  std::string bytes(headerBytes, '\0');
  const auto count = source->read(bytes.data(), bytes.size());
  if (!count) return count.error();
  if (*count < headerBytes) return cutOffFile(file);
  return bytes;
}

}  // namespace

Result<VolumeFile> readNiftiHeader(const std::filesystem::path& file)
{
  const auto bytes = headerOf(file);
  if (!bytes) return bytes.error();
  const bool isBigEndian = Header(*bytes, false).bits(0, 4) != headerBytes;
  const Header header(*bytes, isBigEndian);
  const std::string name = file.string();
  if (bytes->substr(4, 3) == "n+2" || bytes->substr(4, 3) == "ni2")
    return Error{
        "%1 is a NIfTI-2 file; NIfTI-1 is read. Save the volume as NIfTI-1 (.nii or .nii.gz) or as "
        "NRRD.",
        name};
  if (header.bits(0, 4) != headerBytes || bytes->substr(344, 4) != std::string("n+1", 4))
    return Error{
        "%1 is not a NIfTI-1 file with its voxels in it. Save the volume as .nii or .nii.gz.",
        name};
  VolumeFile volume;
  volume.format = "NIfTI";
  volume.bytes = &nifti::bytes;
  volume.voxelFile = file;
  volume.packing = Packing::detected;
  volume.coding.isBigEndian = isBigEndian;
  if (const auto done = niftiSize(header, file, volume); !done) return done.error();
  if (const auto done = niftiType(header, name, volume); !done) return done.error();
  const int unitCode = static_cast<unsigned char>((*bytes)[123]);
  const auto unit_mm = unitOf(unitCode);
  if (!unit_mm)
    return Error{
        "%1 states its unit of length by the code %2, which is none. Export it again in "
        "millimeters.",
        name, unitCode & 7};
  const auto place = placeOf(header, name, volume.size, *unit_mm);
  if (!place) return place.error();
  volume.warnings = place->warnings;
  volume.lps_PI = place->ras;
  volume.lps_PI.topRows<3>() *= *unit_mm;
  volume.lps_PI.topRows<2>() *= -1.0;
  if (const auto done = checkVoxels(file, volume.lps_PI, unitText(unitCode)); !done)
    return done.error();
  if (const auto done = readScaling(header, name, volume); !done) return done.error();
  const double first = header.number(108);
  if (!(first >= headerBytes && first < 1e7) || first != std::floor(first))
    return Error{"%1 is damaged: its voxels begin nowhere. Export it again.", name};
  volume.skipped = static_cast<std::size_t>(first);
  if (const auto done = checkDataLength(file, volume); !done) return done.error();
  return volume;
}

}  // namespace perilymph::imaging
