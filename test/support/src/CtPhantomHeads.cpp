// SPDX-License-Identifier: BSD-3-Clause

// Volumes made of phantoms: both ears of a head, and corners that were not measured.

#include <cmath>
#include <stdexcept>
#include <vector>

#include "CtPhantomAnatomy.h"
#include "perilymph/test/CtPhantom.h"

namespace perilymph::test {
namespace {

constexpr double softTissue = 60.0;

ct::CtVolume made(const std::array<int, 3>& size, const Eigen::Matrix4d& lps,
                  std::vector<std::int16_t> voxels)
{
  auto volume = ct::CtVolume::make(size, lps, std::move(voxels), {"", "", "phantom"});
  if (!volume) throw std::runtime_error(volume.error().message);
  return *std::move(volume);
}

}  // namespace

TwoEars makeTwoEars(std::uint64_t seed, const PhantomScan& scan, double apart_mm)
{
  // Both volumes have the voxels of one grid: their distance is a whole number of them.
  const double step = scan.spacing_mm.x();
  const int shift = static_cast<int>(std::lround(apart_mm / step));
  PhantomCondition right, left;
  right.isRight = true;
  right.center_P = Eigen::Vector3d(-0.5 * shift * step, 4.0, 20.0);
  left.isRight = false;
  left.center_P = Eigen::Vector3d(0.5 * shift * step, 4.0, 20.0);
  CtPhantom first = makeCtPhantom(seed, scan, right), second = makeCtPhantom(seed + 1, scan, left);
  std::array<int, 3> size = first.volume.size();
  const std::array<int, 3> ear = size;
  size[0] += shift;
  Dice dice(seed ^ 0x51a3U);
  std::vector<std::int16_t> voxels;
  for (int k = 0; k < size[2]; ++k)
    for (int j = 0; j < size[1]; ++j)
      for (int i = 0; i < size[0]; ++i) {
        if (i < ear[0])
          voxels.push_back(first.volume.voxel(i, j, k));
        else if (i >= shift)
          voxels.push_back(second.volume.voxel(i - shift, j, k));
        else
          voxels.push_back(static_cast<std::int16_t>(
              std::lround(softTissue + 0.5 * scan.noise * dice.normal())));
      }
  ct::CtVolume volume = made(size, first.volume.lpsFromIndex(), std::move(voxels));
  return {std::move(volume), std::move(first), std::move(second)};
}

ct::CtVolume withEmptyCorner(const ct::CtVolume& volume, const Eigen::Vector3d& point_P,
                             const Eigen::Vector3d& normal_P, std::int16_t value)
{
  std::vector<std::int16_t> voxels(volume.voxels().begin(), volume.voxels().end());
  std::size_t at = 0;
  for (int k = 0; k < volume.size()[2]; ++k)
    for (int j = 0; j < volume.size()[1]; ++j)
      for (int i = 0; i < volume.size()[0]; ++i, ++at)
        if ((volume.toLps(Eigen::Vector3d(i, j, k)) - point_P).dot(normal_P) > 0.0)
          voxels[at] = value;
  return made(volume.size(), volume.lpsFromIndex(), std::move(voxels));
}

}  // namespace perilymph::test
