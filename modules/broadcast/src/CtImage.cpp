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

Result<PackedImage> packImage(const PlacedCt& ct)
{
  auto part = ct.volume->crop(centerOf(ct), radiusOf(*ct.volume));
  if (!part) return part.error();
  const Eigen::Matrix3d axes_WP = ct.axes_PW.inverse();
  Eigen::Matrix4d placed_WI = part->lpsFromIndex();
  placed_WI.topLeftCorner<3, 3>() = axes_WP * part->lpsFromIndex().topLeftCorner<3, 3>();
  placed_WI.topRightCorner<3, 1>() =
      axes_WP * (part->lpsFromIndex().topRightCorner<3, 1>() - ct.origin_P);
  return std::make_shared<const Bytes>(imageMessage(*part, placed_WI));
}

}  // namespace perilymph::broadcast
