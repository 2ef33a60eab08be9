// SPDX-License-Identifier: BSD-3-Clause
#include "ImplantScanner.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "perilymph/foundation/Units.h"

namespace perilymph::test {
namespace {

constexpr double fieldOfView_mm = 22.0;

struct Grid {
  std::array<int, 3> size;
  std::vector<float> values;
  std::size_t index(int i, int j, int k) const
  {
    return (static_cast<std::size_t>(k) * static_cast<std::size_t>(size[1]) +
            static_cast<std::size_t>(j)) *
               static_cast<std::size_t>(size[0]) +
           static_cast<std::size_t>(i);
  }
};

void blur(Grid& grid, int axis, double sigma)
{
  const int reach = std::max(1, static_cast<int>(std::ceil(3.0 * sigma)));
  std::vector<float> kernel;
  float sum = 0.0F;
  for (int d = -reach; d <= reach; ++d) {
    kernel.push_back(static_cast<float>(std::exp(-0.5 * d * d / (sigma * sigma))));
    sum += kernel.back();
  }
  const int n = grid.size[static_cast<std::size_t>(axis)];
  const std::size_t stride = axis == 0   ? 1
                             : axis == 1 ? static_cast<std::size_t>(grid.size[0])
                                         : static_cast<std::size_t>(grid.size[0] * grid.size[1]);
  std::vector<float> line(static_cast<std::size_t>(n));
  for (std::size_t start = 0; start < grid.values.size(); ++start) {
    if ((start / stride) % static_cast<std::size_t>(n) != 0) continue;
    for (int i = 0; i < n; ++i)
      line[static_cast<std::size_t>(i)] = grid.values[start + stride * static_cast<std::size_t>(i)];
    for (int i = 0; i < n; ++i) {
      float value = 0.0F;
      for (int d = -reach; d <= reach; ++d)
        value += kernel[static_cast<std::size_t>(d + reach)] *
                 line[static_cast<std::size_t>(std::clamp(i + d, 0, n - 1))];
      grid.values[start + stride * static_cast<std::size_t>(i)] = value / sum;
    }
  }
}

}  // namespace

ct::CtVolume scanned(const ImplantScene& scene, const ImplantScan& scan, std::uint64_t seed)
{
  Dice dice(seed ^ 0x5ca9U);
  std::array<int, 3> times{}, coarse{};
  Grid fine{};
  Eigen::Vector3d cell;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double spacing = scan.spacing_mm[static_cast<Eigen::Index>(axis)];
    times[axis] = std::max(1, static_cast<int>(std::ceil(spacing / 0.16)));
    cell[static_cast<Eigen::Index>(axis)] = spacing / times[axis];
    coarse[axis] = static_cast<int>(fieldOfView_mm / spacing);
    fine.size[axis] = coarse[axis] * times[axis];
  }
  fine.values.resize(static_cast<std::size_t>(fine.size[0]) *
                     static_cast<std::size_t>(fine.size[1]) *
                     static_cast<std::size_t>(fine.size[2]));
  Eigen::Matrix4d lps = Eigen::Matrix4d::Identity();
  for (Eigen::Index axis = 0; axis < 3; ++axis) lps(axis, axis) = scan.spacing_mm[axis];
  const Eigen::Vector3d half(0.5 * (coarse[0] - 1), 0.5 * (coarse[1] - 1), 0.5 * (coarse[2] - 1));
  lps.topRightCorner<3, 1>() = scene.center_P - lps.topLeftCorner<3, 3>() * half;
  const Eigen::Matrix4d index_W = lps.inverse() * scene.pose_PW;
  const Eigen::Matrix4d w_index = index_W.inverse();
  for (int k = 0; k < fine.size[2]; ++k)
    for (int j = 0; j < fine.size[1]; ++j)
      for (int i = 0; i < fine.size[0]; ++i) {
        const Eigen::Vector4d index((i + 0.5) / times[0] - 0.5, (j + 0.5) / times[1] - 0.5,
                                    (k + 0.5) / times[2] - 0.5, 1.0);
        fine.values[fine.index(i, j, k)] = static_cast<float>(
            scene.anatomy->intensity((w_index * index).head<3>(), 60.0, cell.mean()));
      }
  constexpr double metalHu = 400000.0;
  for (const MetalPiece& piece : scene.metal) {
    const Eigen::Vector3d index = (index_W * piece.point_W.homogeneous()).head<3>();
    std::array<int, 3> at{};
    bool isIn = true;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      at[axis] = static_cast<int>(
          std::floor((index[static_cast<Eigen::Index>(axis)] + 0.5) * times[axis]));
      isIn = isIn && at[axis] >= 0 && at[axis] < fine.size[axis];
    }
    if (isIn)
      fine.values[fine.index(at[0], at[1], at[2])] +=
          static_cast<float>(metalHu * piece.volume_mm3 / cell.prod());
  }
  for (int axis = 0; axis < 3; ++axis) {
    const auto a = static_cast<Eigen::Index>(axis);
    const double width =
        axis == 2 ? scan.sliceProfile_mm : std::hypot(scan.detector_mm, scan.focalSpot_mm);
    blur(fine, axis, std::max(0.3, 0.6 * width / cell[a]));
  }
  std::vector<std::int16_t> voxels;
  const double highest = scan.isClipped ? 3071.0 : 30710.0;
  for (int k = 0; k < coarse[2]; ++k)
    for (int j = 0; j < coarse[1]; ++j)
      for (int i = 0; i < coarse[0]; ++i) {
        double sum = 0.0;
        for (int c = 0; c < times[2]; ++c)
          for (int b = 0; b < times[1]; ++b)
            for (int a = 0; a < times[0]; ++a)
              sum += static_cast<double>(
                  fine.values[fine.index(i * times[0] + a, j * times[1] + b, k * times[2] + c)]);
        const double value = sum / (times[0] * times[1] * times[2]) + 100.0 * dice.normal();
        voxels.push_back(
            static_cast<std::int16_t>(std::lround(std::clamp(value, -1024.0, highest))));
      }
  auto volume = ct::CtVolume::make(coarse, lps, std::move(voxels), {"", "", "phantom"});
  if (!volume) throw std::runtime_error(volume.error().message);
  return *std::move(volume);
}

}  // namespace perilymph::test
