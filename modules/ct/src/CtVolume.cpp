// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/ct/CtVolume.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <utility>

namespace perilymph::ct {

Result<CtVolume> CtVolume::make(const std::array<int, 3>& size, const Eigen::Matrix4d& lps_PI,
                                std::vector<std::int16_t> voxels, CtProvenance provenance)
{
  std::size_t count = 1;
  for (const int along : size) {
    if (along < 2)
      return Error{
          "The volume has %1 x %2 x %3 voxels; at least 2 are needed along every axis. Choose "
          "another series.",
          size[0], size[1], size[2]};
    count *= static_cast<std::size_t>(along);
  }
  if (voxels.size() != count)
    return Error{
        "The volume holds %1 voxels where its size says %2. The file is damaged; export the series "
        "again.",
        voxels.size(), count};
  const Eigen::Matrix3d axes = lps_PI.topLeftCorner<3, 3>();
  const double lengths = axes.colwise().norm().prod();
  if (!lps_PI.allFinite() || !(lengths > 0.0) || !(std::fabs(axes.determinant()) > 0.1 * lengths))
    return Error{
        "The volume's orientation matrix is singular or not finite, so no length can be measured "
        "in it. Export the series again with its positions and orientation."};
  CtVolume volume;
  volume.size_ = size;
  volume.lps_PI_ = lps_PI;
  volume.axes_ = axes;
  volume.inverse_ = axes.inverse();
  volume.origin_ = lps_PI.topRightCorner<3, 1>();
  volume.voxels_ = std::move(voxels);
  volume.provenance_ = std::move(provenance);
  return volume;
}

Eigen::Vector3d CtVolume::spacing_mm() const { return axes_.colwise().norm().transpose(); }

Eigen::Vector3d CtVolume::center_P() const
{
  return toLps(0.5 * Eigen::Vector3d(size_[0] - 1, size_[1] - 1, size_[2] - 1));
}

bool CtVolume::contains(const Eigen::Vector3d& point_P) const
{
  const Eigen::Vector3d index = toIndex(point_P);
  for (int axis = 0; axis < 3; ++axis)
    if (!(index[axis] >= 0.0 && index[axis] <= size_[static_cast<std::size_t>(axis)] - 1))
      return false;
  return true;
}

std::size_t CtVolume::unmeasuredCount() const noexcept
{
  return static_cast<std::size_t>(std::count(voxels_.begin(), voxels_.end(), unmeasured));
}

std::optional<double> CtVolume::sample(const Eigen::Vector3d& point_P) const
{
  if (!contains(point_P)) return std::nullopt;
  const Eigen::Vector3d index = toIndex(point_P);
  std::array<int, 3> low{};
  std::array<double, 3> past{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double along = index[static_cast<Eigen::Index>(axis)];
    low[axis] = std::min(static_cast<int>(along), size_[axis] - 2);
    past[axis] = along - low[axis];
  }
  double sum = 0.0;
  for (int corner = 0; corner < 8; ++corner) {
    const int di = corner & 1, dj = (corner >> 1) & 1, dk = corner >> 2;
    const double weight = (di != 0 ? past[0] : 1.0 - past[0]) *
                          (dj != 0 ? past[1] : 1.0 - past[1]) * (dk != 0 ? past[2] : 1.0 - past[2]);
    const std::int16_t value = voxel(low[0] + di, low[1] + dj, low[2] + dk);
    if (value == unmeasured && weight > 0.0) return std::nullopt;
    sum += weight * value;
  }
  return sum;
}

Result<CtVolume> CtVolume::crop(const Eigen::Vector3d& center_P, double radius_mm) const
{
  if (!contains(center_P))
    return Error{
        "The point lies outside the volume. Choose a point inside the scan, in LPS millimeters."};
  const Eigen::Vector3d center = toIndex(center_P);
  const Eigen::Vector3d spacing = spacing_mm();
  std::array<int, 3> first{}, size{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto a = static_cast<Eigen::Index>(axis);
    const int low = static_cast<int>(std::floor(center[a] - radius_mm / spacing[a]));
    const int high = static_cast<int>(std::ceil(center[a] + radius_mm / spacing[a]));
    first[axis] = std::clamp(low, 0, size_[axis] - 2);
    size[axis] = std::clamp(high, first[axis] + 1, size_[axis] - 1) - first[axis] + 1;
  }
  std::vector<std::int16_t> voxels;
  voxels.reserve(static_cast<std::size_t>(size[0]) * static_cast<std::size_t>(size[1]) *
                 static_cast<std::size_t>(size[2]));
  for (int k = 0; k < size[2]; ++k)
    for (int j = 0; j < size[1]; ++j)
      for (int i = 0; i < size[0]; ++i)
        voxels.push_back(voxel(first[0] + i, first[1] + j, first[2] + k));
  Eigen::Matrix4d lps = lps_PI_;
  lps.topRightCorner<3, 1>() = toLps(Eigen::Vector3d(first[0], first[1], first[2]));
  return make(size, lps, std::move(voxels), provenance_);
}

}  // namespace perilymph::ct
