// SPDX-License-Identifier: BSD-3-Clause
#include "VolumeGeometry.h"

#include <Eigen/Geometry>
#include <charconv>
#include <cmath>
#include <numbers>

#include "perilymph/imaging/CtSeries.h"

namespace perilymph::imaging {
namespace {

// From micro-CT to the thickest slices; a CT of the temporal bone has 0.1 to 1 mm.
constexpr double minVoxel_mm = 0.01, maxVoxel_mm = 10.0;
constexpr double rounding = 1e-6;
constexpr double maxShear = 1e-3;  // [rad], 0.01 mm over a cochlea

std::string fourDigits(double value)
{
  std::array<char, 40> text{};
  const auto done =
      std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::general, 4);
  return {text.data(), done.ptr};
}

}  // namespace

std::string alongAxis(Eigen::Index axis)
{
  return std::string(" along ") + "ijk"[static_cast<std::size_t>(axis)];
}

Result<Done> checkVoxels(const std::filesystem::path& file, const Eigen::Matrix4d& lps_PI,
                         const std::string& unit)
{
  if (!lps_PI.allFinite())
    return Error{file.string() +
                 " has a matrix with values that are no finite numbers. Export it again with its "
                 "orientation."};
  const Eigen::Matrix3d axes = lps_PI.topLeftCorner<3, 3>();
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    const double length_mm = axes.col(axis).norm();
    if (!(length_mm >= minVoxel_mm * (1.0 - rounding) &&
          length_mm <= maxVoxel_mm * (1.0 + rounding)))
      return Error{file.string() + " has voxels of " + fourDigits(length_mm) + " mm" +
                   alongAxis(axis) + " where 0.01 to 10 mm are read; its unit of length is " +
                   unit + ". Export it again in millimeters."};
  }
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    const Eigen::Index next = (axis + 1) % 3;
    const double cosine = axes.col(axis).normalized().dot(axes.col(next).normalized());
    if (!(std::fabs(cosine) <= maxShear))
      return Error{file.string() + " has axes " + "ijk"[axis] + " and " + "ijk"[next] +
                   " that meet at " + fourDigits(std::acos(cosine) * 180.0 / std::numbers::pi) +
                   " degrees, not at 90 within 0.057. Resample it to right angles, or open the "
                   "original series."};
  }
  constexpr double farthest_mm = 1e6;  // as of DICOM slices
  if (lps_PI.topRightCorner<3, 1>().norm() > farthest_mm)
    return Error{file.string() +
                 " lies more than 1 km from the origin of the patient's coordinates, where no "
                 "scanner measures. Export it again with its orientation."};
  return Done{};
}

Result<Done> checkVolumeSize(const std::filesystem::path& file, const std::array<double, 3>& size)
{
  double voxels = 1.0;
  for (const double along : size) {
    if (!(along >= 2.0 && along <= 65'535.0) || along != std::floor(along))
      return Error{file.string() +
                   " holds no volume: each of its sizes must be 2 to 65535. Export it again."};
    voxels *= along;
  }
  if (voxels > static_cast<double>(maxCtVoxels))
    return Error{file.string() + " has " + std::to_string(std::lround(voxels / 1e6)) +
                 " million voxels; at most " + std::to_string(maxCtVoxels / 1'000'000) +
                 " million are read. Export the region of the temporal bone."};
  return Done{};
}

}  // namespace perilymph::imaging
