// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/test/RealEarTruth.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "perilymph/foundation/Units.h"

namespace perilymph::test {
namespace {

constexpr double half = 50.0;  // labels are 0 and 100

double outermost(const RealEar& ear, double angle, double high_mm)
{
  double best = 0.0;
  for (double z = -1.3; z <= high_mm; z += 0.05)
    // No cochlea is wider; beyond are vestibule and canals.
    for (double r = 5.5; r > std::max(best, 0.5); r -= 0.01) {
      const auto label =
          ear.label.sample(ear.center_P + ear.axes_PW * Eigen::Vector3d(r * std::cos(angle),
                                                                        r * std::sin(angle), z));
      if (label && *label >= half) best = r;
    }
  return best;
}

/// Centers of the faces between voxels inside and outside a label.
std::vector<Eigen::Vector3d> labelSurface(const ct::CtVolume& label)
{
  std::vector<Eigen::Vector3d> middles;
  const std::array<int, 3>& size = label.size();
  for (int k = 0; k + 1 < size[2]; ++k)
    for (int j = 0; j + 1 < size[1]; ++j)
      for (int i = 0; i + 1 < size[0]; ++i)
        for (int axis = 0; axis < 3; ++axis) {
          const int di = axis == 0 ? 1 : 0, dj = axis == 1 ? 1 : 0, dk = axis == 2 ? 1 : 0;
          if (label.voxel(i, j, k) != label.voxel(i + di, j + dj, k + dk))
            middles.push_back(label.toLps({i + 0.5 * di, j + 0.5 * dj, k + 0.5 * dk}));
        }
  return middles;
}

}  // namespace

LabelMeasures measureLabel(const RealEar& ear)
{
  const double window =
      (ear.axes_PW.transpose() * (ear.roundWindow_P - ear.center_P)).head<2>().norm();
  return {window + outermost(ear, pi, 1.5),
          outermost(ear, 0.5 * pi, 1.5) + outermost(ear, 1.5 * pi, 1.0)};
}

Eigen::Vector3d clickOf(const RealEar& ear)
{
  return 0.7 * ear.center_P + 0.3 * ear.apex_P + ear.axes_PW * Eigen::Vector3d(1.5, 0.8, 0.0);
}

double meanDistanceToLabel(const RealEar& ear, const ct::CochleaMeasures& found)
{
  const std::vector<Eigen::Vector3d> surface = labelSurface(ear.label);
  const std::size_t around = found.wallPointsPerRing;
  const std::size_t rings = std::min<std::size_t>(found.wall_P.size() / around, 180);
  double sum = 0.0;
  int count = 0;
  for (std::size_t ring = 5; ring < rings; ++ring)
    for (std::size_t k = 0; k < around; k += 2) {
      // The inner third faces the modiolus, where labels do not follow the bone.
      if (k > around / 3 && k < 2 * around / 3) continue;
      double minimum = 1e9;
      for (const Eigen::Vector3d& point : surface)
        minimum = std::min(minimum, (point - found.wall_P[ring * around + k]).squaredNorm());
      sum += std::sqrt(minimum);
      ++count;
    }
  return sum / count;
}

}  // namespace perilymph::test
