// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/broadcast/CtImage.h"

#include <Eigen/LU>
#include <algorithm>

#include "Messages.h"

namespace perilymph::broadcast {

namespace {

// The message states sizes in 16 bits.
constexpr double maxSize = 65'000.0;

/// The distance within which a message has room for all voxels [mm].
double radiusOf(const ct::CtVolume& volume)
{
  const Eigen::Array3d spacing_mm = volume.spacing_mm();
  const Eigen::Array3d whole(volume.size()[0], volume.size()[1], volume.size()[2]);
  double radius_mm = imageRadius_mm;
  const auto size = [&] { return whole.min(2.0 * radius_mm / spacing_mm + 3.0).eval(); };
  while (size().prod() > double(maxImageVoxels) || size().maxCoeff() > maxSize) radius_mm *= 0.98;
  return radius_mm;
}

/// The place in the volume next to the origin of W, which a clipped scan may not contain.
Eigen::Vector3d centerOf(const PlacedCt& ct)
{
  const auto [i, j, k] = ct.volume->size();
  const Eigen::Array3d last(i - 1, j - 1, k - 1);
  const Eigen::Array3d index = ct.volume->toIndex(ct.origin_P);
  return ct.volume->toLps(index.max(0.5).min(last - 0.5));
}

}  // namespace

Placement placementOf(const PlacedCt& ct)
{
  Placement placement;
  const Eigen::Vector3d rasOfLps(-1.0, -1.0, 1.0);
  for (Eigen::Index row = 0; row < 3; ++row) {
    const auto to = static_cast<std::size_t>(row);
    placement.origin_R[to] = rasOfLps[row] * ct.origin_P[row] * 1e-3;
    for (Eigen::Index axis = 0; axis < 3; ++axis)
      placement.axis_R[static_cast<std::size_t>(axis)][to] = rasOfLps[row] * ct.axes_PW(row, axis);
  }
  return placement;
}

Result<PackedImage> packImage(const PlacedCt& ct, Coordinates coordinates)
{
  auto part = ct.volume->crop(centerOf(ct), radiusOf(*ct.volume));
  if (!part) return part.error();
  // S: the frame that is sent.
  Eigen::Matrix4d placed_SP = Eigen::Matrix4d::Identity();
  if (coordinates == Coordinates::patient) {
    placed_SP.diagonal().head<2>().setConstant(-1.0);  // RAS of LPS
  } else {
    placed_SP.topLeftCorner<3, 3>() = ct.axes_PW.inverse();
    placed_SP.topRightCorner<3, 1>() = -ct.axes_PW.inverse() * ct.origin_P;
  }
  return std::make_shared<const Bytes>(imageMessage(*part, placed_SP * part->lpsFromIndex()));
}

}  // namespace perilymph::broadcast
