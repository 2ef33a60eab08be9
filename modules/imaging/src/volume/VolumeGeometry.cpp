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

Sentence alongAxis(Eigen::Index axis) { return Sentence{" along %1", "ijk"[axis]}; }

Result<void> checkVoxels(const std::filesystem::path& file, const Eigen::Matrix4d& lps_PI,
                         const Sentence& unit)
{
  if (!lps_PI.allFinite())
    return Error{
        "%1 has a matrix with values that are no finite numbers. Export it again with its "
        "orientation.",
        file};
  const Eigen::Matrix3d axes = lps_PI.topLeftCorner<3, 3>();
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    const double length_mm = axes.col(axis).norm();
    if (!(length_mm >= minVoxel_mm * (1.0 - rounding) &&
          length_mm <= maxVoxel_mm * (1.0 + rounding)))
      return Error{
          "%1 has voxels of %2 mm%3 where 0.01 to 10 mm are read; its unit of length is %4. Export "
          "it again in millimeters.",
          file, fourDigits(length_mm), alongAxis(axis), unit};
  }
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    const Eigen::Index next = (axis + 1) % 3;
    const double cosine = axes.col(axis).normalized().dot(axes.col(next).normalized());
    if (!(std::fabs(cosine) <= maxShear))
      return Error{
          "%1 has axes %2 and %3 that meet at %4 degrees, not at 90 within 0.057. Resample it to "
          "right angles, or open the original series.",
          file, "ijk"[axis], "ijk"[next], fourDigits(std::acos(cosine) * 180.0 / std::numbers::pi)};
  }
  constexpr double farthest_mm = 1e6;  // as of DICOM slices
  if (lps_PI.topRightCorner<3, 1>().norm() > farthest_mm)
    return Error{
        "%1 lies more than 1 km from the origin of the patient's coordinates, where no scanner "
        "measures. Export it again with its orientation.",
        file};
  return {};
}

Result<void> checkVolumeSize(const std::filesystem::path& file, const std::array<double, 3>& size)
{
  double voxels = 1.0;
  for (const double along : size) {
    if (!(along >= 2.0 && along <= 65'535.0) || along != std::floor(along))
      return Error{"%1 holds no volume: each of its sizes must be 2 to 65535. Export it again.",
                   file};
    voxels *= along;
  }
  if (voxels > static_cast<double>(maxCtVoxels))
    return Error{
        "%1 has %2 million voxels; at most %3 million are read. Export the region of the temporal "
        "bone.",
        file, std::lround(voxels / 1e6), maxCtVoxels / 1'000'000};
  return {};
}

}  // namespace perilymph::imaging
