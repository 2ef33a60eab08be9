// SPDX-License-Identifier: BSD-3-Clause

// Volumes made of phantoms: both ears of a head, and corners that were not measured.

#include <algorithm>
#include <cmath>
#include <cstddef>
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

ct::CtVolume coarser(const ct::CtVolume& volume, const PhantomScan& scan, double blur_mm)
{
  const std::array<int, 3> size = volume.size();
  const Eigen::Vector3d spacing = volume.spacing_mm();
  std::vector<double> values(volume.voxels().begin(), volume.voxels().end());
  const std::array<std::size_t, 3> stride{
      1, static_cast<std::size_t>(size[0]),
      static_cast<std::size_t>(size[0]) * static_cast<std::size_t>(size[1])};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double wanted = axis < 2 ? scan.blurInPlane_mm : scan.blurAxial_mm;
    const double sigma =
        std::sqrt(wanted * wanted - blur_mm * blur_mm) / spacing[static_cast<Eigen::Index>(axis)];
    const int reach = static_cast<int>(std::ceil(3.0 * sigma));
    const std::vector<double> sharp = values;
    for (std::size_t at = 0; at < values.size(); ++at) {
      const int i = static_cast<int>(at / stride[axis]) % size[axis];
      double sum = 0.0, weights = 0.0;
      for (int d = std::max(-reach, -i); d <= std::min(reach, size[axis] - 1 - i); ++d) {
        const double weight = std::exp(-0.5 * d * d / (sigma * sigma));
        const auto by = d * static_cast<std::ptrdiff_t>(stride[axis]);
        sum += weight * sharp[static_cast<std::size_t>(static_cast<std::ptrdiff_t>(at) + by)];
        weights += weight;
      }
      values[at] = sum / weights;
    }
  }
  std::vector<std::int16_t> blurred;
  for (const double value : values)
    blurred.push_back(static_cast<std::int16_t>(std::lround(value)));
  const ct::CtVolume fine = made(size, volume.lpsFromIndex(), std::move(blurred));
  std::array<int, 3> fewer{};
  Eigen::Matrix4d lps = volume.lpsFromIndex();
  const Eigen::Vector3d times = scan.spacing_mm.cwiseQuotient(spacing);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto a = static_cast<Eigen::Index>(axis);
    fewer[axis] = static_cast<int>((size[axis] - 1) / times[a]) + 1;
    lps.col(a) *= times[a];
  }
  std::vector<std::int16_t> voxels;
  for (int k = 0; k < fewer[2]; ++k)
    for (int j = 0; j < fewer[1]; ++j)
      for (int i = 0; i < fewer[0]; ++i) {
        const Eigen::Vector3d index = times.cwiseProduct(Eigen::Vector3d(i, j, k));
        voxels.push_back(static_cast<std::int16_t>(
            std::lround(fine.sample(fine.toLps(index)).value_or(ct::unmeasured))));
      }
  return made(fewer, lps, std::move(voxels));
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
