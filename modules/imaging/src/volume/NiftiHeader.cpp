// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Geometry>
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <map>
#include <optional>
#include <string>

#include "VolumeFile.h"

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

/// Index to RAS; none where the file has neither an SForm nor a QForm.
std::optional<Eigen::Matrix4d> rasFromIndex(const Header& header)
{
  Eigen::Matrix4d ras = Eigen::Matrix4d::Identity();
  if (header.word(254) > 0) {
    for (Eigen::Index row = 0; row < 3; ++row)
      for (Eigen::Index column = 0; column < 4; ++column)
        ras(row, column) = header.number(280 + 16 * static_cast<std::size_t>(row) +
                                         4 * static_cast<std::size_t>(column));
    return ras;
  }
  if (header.word(252) <= 0) return std::nullopt;
  // nifti1.h, method 2: a quaternion without its real part, and a handedness.
  const double b = header.number(256), c = header.number(260), d = header.number(264);
  const double rest = 1.0 - b * b - c * c - d * d;
  const Eigen::Quaterniond turn(rest > 0.0 ? std::sqrt(rest) : 0.0, b, c, d);
  Eigen::Matrix3d axes = turn.normalized().toRotationMatrix();
  for (Eigen::Index axis = 0; axis < 3; ++axis)
    axes.col(axis) *= std::fabs(header.number(80 + 4 * static_cast<std::size_t>(axis)));
  if (header.number(76) < 0.0) axes.col(2) = -axes.col(2);
  ras.topLeftCorner<3, 3>() = axes;
  for (Eigen::Index axis = 0; axis < 3; ++axis)
    ras(axis, 3) = header.number(268 + 4 * static_cast<std::size_t>(axis));
  return ras;
}

}  // namespace

Result<VolumeFile> readNiftiHeader(const std::filesystem::path& file)
{
  const auto bytes = readBytes(file, 0, headerBytes, {});
  if (!bytes) return bytes.error();
  const bool isBigEndian = Header(*bytes, false).bits(0, 4) != headerBytes;
  const Header header(*bytes, isBigEndian);
  if (header.bits(0, 4) != headerBytes || bytes->substr(344, 3) != "n+1")
    return Error{file.string() +
                 " is no NIfTI-1 file with its voxels in it. Save the volume as .nii or .nii.gz."};
  const int dimensions = header.word(40);
  for (int axis = 4; axis <= std::min(dimensions, 7); ++axis)
    if (header.word(40 + 2 * static_cast<std::size_t>(axis)) > 1)
      return Error{file.string() + " holds more than one volume. Save the CT alone."};
  VolumeFile volume;
  volume.format = "NIfTI";
  volume.isBigEndian = isBigEndian;
  const std::array<double, 3> size{1.0 * header.word(42), 1.0 * header.word(44),
                                   1.0 * header.word(46)};
  if (const auto done = checkVolumeSize(file, size); !done) return done.error();
  for (std::size_t axis = 0; axis < 3; ++axis) volume.size[axis] = static_cast<int>(size[axis]);
  static const std::map<int, VoxelType> types = {
      {2, VoxelType::uint8},    {4, VoxelType::int16},    {8, VoxelType::int32},
      {16, VoxelType::float32}, {64, VoxelType::float64}, {256, VoxelType::int8},
      {512, VoxelType::uint16}, {768, VoxelType::uint32}};
  const auto type = types.find(header.word(70));
  if (type == types.end())
    return Error{file.string() + " holds voxels of the type " + std::to_string(header.word(70)) +
                 ", which are no gray values. Save the CT as 16-bit numbers."};
  volume.type = type->second;
  const auto ras = rasFromIndex(header);
  const auto unit = unitOf(static_cast<unsigned char>((*bytes)[123]));
  if (!ras || !unit)
    return Error{file.string() +
                 " has neither an SForm nor a QForm in a unit of length, so left and right are "
                 "not known. Export it with its orientation."};
  volume.lps_PI = *ras;
  volume.lps_PI.topRows<3>() *= *unit;
  volume.lps_PI.topRows<2>() *= -1.0;
  if (header.number(112) != 0.0) {
    volume.slope = header.number(112);
    volume.intercept = header.number(116);
  }
  const double first = header.number(108);
  if (!(first >= headerBytes && first < 1e7))
    return Error{file.string() + " is damaged: its voxels begin nowhere. Export it again."};
  volume.firstByte = static_cast<std::size_t>(first);
  return volume;
}

}  // namespace perilymph::imaging
