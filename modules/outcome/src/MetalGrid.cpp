// SPDX-License-Identifier: BSD-3-Clause
#include "MetalGrid.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "perilymph/foundation/Math.h"
#include "perilymph/foundation/Quantile.h"

namespace perilymph::outcome {

namespace {

constexpr double finest_mm = 0.15, coarsestGrid_mm = 0.25;  // of the grid's step
constexpr double boneFrom_mm = 0.6, boneTo_mm = 1.2;        // beyond the wall
constexpr double quartileSd = 0.6745;                       // of a normal distribution
constexpr double minFloor = 250.0;                          // above the bone [intensity]
constexpr std::size_t clippedVoxels = 12;                   // of the largest value: it is a limit
constexpr double widerBy = 1.6;  // Marr and Hildreth 1980: nearest to the Laplacian

/// Intensities of the bone around the lumen.
std::vector<double> boneAround(const ct::CtVolume& volume, const ct::CochleaMeasures& measures)
{
  std::vector<double> bone;
  const std::size_t ring = measures.wallPointsPerRing;
  if (ring == 0) return bone;
  for (std::size_t first = 0; first + ring <= measures.wall_P.size(); first += ring) {
    Eigen::Vector3d center = Eigen::Vector3d::Zero();
    for (std::size_t i = 0; i < ring; ++i)
      center += measures.wall_P[first + i] / static_cast<double>(ring);
    for (std::size_t i = 0; i < ring; i += 2) {
      const Eigen::Vector3d out = measures.wall_P[first + i] - center;
      const Eigen::Vector3d fromAxis = measures.wall_P[first + i] - measures.center_P;
      // toward the modiolus bone is porous, and other turns follow
      if (out.dot(fromAxis - fromAxis.dot(measures.axis_P) * measures.axis_P) < 0.5 * out.norm())
        continue;
      for (double d = boneFrom_mm; d <= boneTo_mm; d += 0.3)
        if (const auto value = volume.sample(measures.wall_P[first + i] + d * out.normalized()))
          bone.push_back(*value);
    }
  }
  return bone;
}

}  // namespace

double MetalGrid::sample(const std::vector<float>& values, const Eigen::Vector3d& point_P) const
{
  const Eigen::Vector3d x = (point_P - first_P) / step_mm;
  std::array<int, 3> low{};
  std::array<double, 3> part{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double at = x[static_cast<Eigen::Index>(axis)];
    if (!(at >= 0.0) || at >= size[axis] - 1) return 0.0;
    low[axis] = static_cast<int>(at);
    part[axis] = at - low[axis];
  }
  double sum = 0.0;
  for (int corner = 0; corner < 8; ++corner) {
    const int a = corner & 1, b = (corner >> 1) & 1, c = corner >> 2;
    const double weight = (a ? part[0] : 1.0 - part[0]) * (b ? part[1] : 1.0 - part[1]) *
                          (c ? part[2] : 1.0 - part[2]);
    sum += weight * static_cast<double>(values[index(low[0] + a, low[1] + b, low[2] + c)]);
  }
  return sum;
}

MetalGrid metalAround(const ct::CtVolume& volume, const Ear& ear, const EarFrame& frame,
                      double reach_mm, double blur_mm)
{
  MetalGrid grid;
  std::vector<double> bone = boneAround(volume, ear.measures);
  grid.bone = bone.empty() ? ear.measures.boneLevel : quantile(bone, 0.5);
  grid.boneSpread =
      bone.empty() ? 100.0 : std::max(50.0, (grid.bone - quantile(bone, 0.25)) / quartileSd);
  std::int16_t largest = ct::unmeasured;
  for (const std::int16_t voxel : volume.voxels()) largest = std::max(largest, voxel);
  if (static_cast<std::size_t>(
          std::count(volume.voxels().begin(), volume.voxels().end(), largest)) >= clippedVoxels)
    grid.ceiling = largest;
  // metal beside the ring makes the bone look uneven; where the scanner clips, half of what is left above it is metal's
  grid.floor = grid.bone + std::max(minFloor, std::min(3.0 * grid.boneSpread,
                                                       0.5 * (grid.ceiling - grid.bone)));

  grid.step_mm = std::clamp(volume.spacing_mm().minCoeff(), finest_mm, coarsestGrid_mm);
  const int half = static_cast<int>(std::ceil(reach_mm / grid.step_mm));
  grid.size = {2 * half + 1, 2 * half + 1, 2 * half + 1};
  grid.first_P = ear.measures.center_P - grid.step_mm * Eigen::Vector3d::Constant(half);
  grid.value.resize(static_cast<std::size_t>(grid.size[0]) *
                    static_cast<std::size_t>(grid.size[1]) *
                    static_cast<std::size_t>(grid.size[2]));
  // bone and lumen as the scanner shows them
  std::vector<float> bonePart(grid.value.size());
  for (int k = 0; k < grid.size[2]; ++k)
    for (int j = 0; j < grid.size[1]; ++j)
      for (int i = 0; i < grid.size[0]; ++i)
        bonePart[grid.index(i, j, k)] =
            static_cast<float>(frame.bonePart(grid.at_P(i, j, k), 0.5 * grid.step_mm));
  bonePart = blurred(grid, bonePart, blur_mm);
  const double bright = std::min(300.0, 0.3 * (grid.ceiling - grid.floor));
  constexpr double usualContent = 100.0;
  for (int k = 0; k < grid.size[2]; ++k)
    for (int j = 0; j < grid.size[1]; ++j)
      for (int i = 0; i < grid.size[0]; ++i) {
        const std::size_t cell = grid.index(i, j, k);
        const double part = std::min(1.0, static_cast<double>(bonePart[cell]));
        const double floor = part * grid.floor + (1.0 - part) * (usualContent + aboveContent);
        const auto value = volume.sample(grid.at_P(i, j, k));
        if (value && *value > grid.floor + bright && frame.placeOf(grid.at_P(i, j, k)).isNearDuct)
          grid.aboveBone_mm3 += grid.step_mm * grid.step_mm * grid.step_mm;
        grid.value[cell] = static_cast<float>(value ? std::max(0.0, *value - floor) : 0.0);
      }
  return grid;
}

std::vector<float> blurred(const MetalGrid& grid, const std::vector<float>& values, double sigma_mm)
{
  const double sigma = sigma_mm / grid.step_mm;
  const int reach = std::max(1, static_cast<int>(std::ceil(3.0 * sigma)));
  std::vector<float> kernel;
  double sum = 0.0;
  for (int d = -reach; d <= reach; ++d) sum += exponential(-0.5 * d * d / (sigma * sigma));
  for (int d = -reach; d <= reach; ++d)
    kernel.push_back(static_cast<float>(exponential(-0.5 * d * d / (sigma * sigma)) / sum));
  std::vector<float> from = values, to(values.size());
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::size_t stride = axis == 0   ? 1
                               : axis == 1 ? static_cast<std::size_t>(grid.size[0])
                                           : static_cast<std::size_t>(grid.size[0]) *
                                                 static_cast<std::size_t>(grid.size[1]);
    const int count = grid.size[axis];
    for (std::size_t cell = 0; cell < from.size(); ++cell) {
      const int here = static_cast<int>((cell / stride) % static_cast<std::size_t>(count));
      float total = 0.0F;
      const int low = std::max(-reach, -here), high = std::min(reach, count - 1 - here);
      for (int d = low; d <= high; ++d)
        total += kernel[static_cast<std::size_t>(d + reach)] *
                 from[cell + static_cast<std::size_t>(static_cast<std::ptrdiff_t>(d) *
                                                      static_cast<std::ptrdiff_t>(stride))];
      to[cell] = total;
    }
    std::swap(from, to);
  }
  return from;
}

std::vector<float> contrastOf(const MetalGrid& grid, double sigma_mm)
{
  std::vector<float> contrast = blurred(grid, grid.value, sigma_mm);
  const std::vector<float> wide = blurred(grid, grid.value, widerBy * sigma_mm);
  for (std::size_t i = 0; i < contrast.size(); ++i) contrast[i] -= wide[i];
  return contrast;
}

std::vector<Blob> blobsOf(const MetalGrid& grid, double sigma_mm)
{
  const std::vector<float> once = blurred(grid, grid.value, sigma_mm);
  const std::vector<float> narrow = contrastOf(grid, sigma_mm);
  const auto minCurvature = [&](int i, int j, int k) {
    const auto at = [&](int a, int b, int c) {
      return static_cast<double>(once[grid.index(i + a, j + b, k + c)]);
    };
    const double here = at(0, 0, 0);
    Eigen::Matrix3d bend;
    bend(0, 0) = at(1, 0, 0) - 2.0 * here + at(-1, 0, 0);
    bend(1, 1) = at(0, 1, 0) - 2.0 * here + at(0, -1, 0);
    bend(2, 2) = at(0, 0, 1) - 2.0 * here + at(0, 0, -1);
    bend(0, 1) = bend(1, 0) = 0.25 * (at(1, 1, 0) - at(1, -1, 0) - at(-1, 1, 0) + at(-1, -1, 0));
    bend(0, 2) = bend(2, 0) = 0.25 * (at(1, 0, 1) - at(1, 0, -1) - at(-1, 0, 1) + at(-1, 0, -1));
    bend(1, 2) = bend(2, 1) = 0.25 * (at(0, 1, 1) - at(0, 1, -1) - at(0, -1, 1) + at(0, -1, -1));
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(bend, Eigen::EigenvaluesOnly);
    return std::max(0.0, -solver.eigenvalues()[2]);
  };
  std::vector<Blob> blobs;
  for (int k = 1; k + 1 < grid.size[2]; ++k)
    for (int j = 1; j + 1 < grid.size[1]; ++j)
      for (int i = 1; i + 1 < grid.size[0]; ++i) {
        const float here = narrow[grid.index(i, j, k)];
        if (here <= 0.0F) continue;
        bool isPeak = true;
        for (int c = -1; c <= 1 && isPeak; ++c)
          for (int b = -1; b <= 1 && isPeak; ++b)
            for (int a = -1; a <= 1 && isPeak; ++a) {
              if (a == 0 && b == 0 && c == 0) continue;
              const float there = narrow[grid.index(i + a, j + b, k + c)];
              // of equal ones the first counts
              isPeak = there < here ||
                       (there == here && (c > 0 || (c == 0 && (b > 0 || (b == 0 && a > 0)))));
            }
        if (!isPeak) continue;
        Eigen::Vector3d off;
        for (int axis = 0; axis < 3; ++axis) {
          const std::array<int, 3> d{axis == 0 ? 1 : 0, axis == 1 ? 1 : 0, axis == 2 ? 1 : 0};
          const double up = static_cast<double>(narrow[grid.index(i + d[0], j + d[1], k + d[2])]);
          const double down = static_cast<double>(narrow[grid.index(i - d[0], j - d[1], k - d[2])]);
          const double bend = up - 2.0 * static_cast<double>(here) + down;
          off[axis] = bend < 0.0 ? std::clamp(0.5 * (down - up) / bend, -0.5, 0.5) : 0.0;
        }
        blobs.push_back({grid.at_P(i, j, k) + grid.step_mm * off, minCurvature(i, j, k)});
      }
  std::stable_sort(blobs.begin(), blobs.end(),
                   [](const Blob& a, const Blob& b) { return a.strength > b.strength; });
  return blobs;
}

}  // namespace perilymph::outcome
