// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/imaging/MeasuredSurface.h"

#include <Eigen/LU>
#include <utility>

namespace perilymph::imaging {

anatomy::Surface measuredSurface(const ct::CochleaMeasures& measures)
{
  anatomy::Surface surface;
  for (const Eigen::Vector3d& point_P : measures.wall_P)
    surface.points.push_back({1e-3 * point_P.x(), 1e-3 * point_P.y(), 1e-3 * point_P.z()});
  surface.triangles = measures.wallTriangles;
  double volume = 0.0;
  for (const auto& corners : surface.triangles) {
    const Eigen::Vector3d a =
        measures.wall_P[static_cast<std::size_t>(corners[0])] - measures.center_P;
    const Eigen::Vector3d b =
        measures.wall_P[static_cast<std::size_t>(corners[1])] - measures.center_P;
    const Eigen::Vector3d c =
        measures.wall_P[static_cast<std::size_t>(corners[2])] - measures.center_P;
    Eigen::Matrix3d sides;
    sides << a, b, c;
    volume += sides.determinant();
  }
  if (volume < 0.0)
    for (auto& corners : surface.triangles) std::swap(corners[1], corners[2]);
  return surface;
}

}  // namespace perilymph::imaging
