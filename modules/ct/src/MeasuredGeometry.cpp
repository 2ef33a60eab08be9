// SPDX-License-Identifier: BSD-3-Clause
#include "MeasuredGeometry.h"

#include <Eigen/Geometry>

namespace perilymph::ct {

void placeAnatomy(const Pose& pose, CochleaMeasures& measures)
{
  const Eigen::Vector3d z = pose.axes_PW.col(2);
  const Eigen::Vector3d toWindow = measures.roundWindow_P - pose.origin_P;
  const Eigen::Vector3d x = (toWindow - z.dot(toWindow) * z).normalized();
  measures.anatomyAxes_PW.col(0) = x;
  measures.anatomyAxes_PW.col(1) = (pose.isRight() ? 1.0 : -1.0) * z.cross(x);
  measures.anatomyAxes_PW.col(2) = z;
  measures.anatomyOrigin_P = pose.origin_P;
}

void addWall(const LumenWall& wall, const Pose& pose, CochleaMeasures& measures)
{
  for (const Eigen::Vector3d& point : wall.points_W) measures.wall_P.push_back(pose.outOf_W(point));
  constexpr int n = LumenWall::around;
  measures.wallPointsPerRing = n;
  for (int ring = 0; ring + 1 < wall.rings(); ++ring)
    for (int k = 0; k < n; ++k) {
      const int a = ring * n + k, b = ring * n + (k + 1) % n;
      measures.wallTriangles.push_back({a, b, a + n});
      measures.wallTriangles.push_back({b, b + n, a + n});
    }
}

}  // namespace perilymph::ct
