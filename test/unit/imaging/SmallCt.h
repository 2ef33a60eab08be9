// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// A small CT whose every voxel is different, in any orientation.

#include <Eigen/Geometry>

#include "perilymph/ct/CtVolume.h"

namespace perilymph::imaging {

/// @param axes_P  Directions of rows, columns and slices, unit.
inline ct::CtVolume smallCt(const Eigen::Matrix3d& axes_P, const Eigen::Vector3d& spacing_mm,
                            const std::array<int, 3>& size = {12, 10, 8})
{
  Eigen::Matrix4d lps = Eigen::Matrix4d::Identity();
  lps.topLeftCorner<3, 3>() = axes_P * spacing_mm.asDiagonal();
  lps.topRightCorner<3, 1>() = Eigen::Vector3d(-31.25, 12.5, -400.75);
  std::vector<std::int16_t> voxels;
  for (int i = 0; i < size[0] * size[1] * size[2]; ++i)
    voxels.push_back(static_cast<std::int16_t>(i * 37 % 4096 - 1024));
  return *ct::CtVolume::make(size, lps, std::move(voxels), {});
}

inline ct::CtVolume smallCt()
{
  return smallCt(Eigen::Matrix3d::Identity(), Eigen::Vector3d(0.3, 0.4, 0.6));
}

}  // namespace perilymph::imaging
