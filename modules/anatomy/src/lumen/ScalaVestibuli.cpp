// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/anatomy/ScalaVestibuli.h"

#include <algorithm>
#include <cmath>

namespace perilymph::anatomy {

Surface vestibuliSurface(const ScalaTympani& scala, int maxTriangles)
{
  // about three times as many rings as a ring has corners: the duct is long
  const int maximum = std::max(maxTriangles, 200);
  const int around = std::max(8, static_cast<int>(std::sqrt(maximum / 6.0)));
  const int rings = std::max(4, (maximum - around) / (2 * around) + 1);
  const double last = scala.lastAngle().si();

  Surface surface;
  double mirror = 0.0;
  for (int i = 0; i < rings; ++i) {
    const double angle = last * i / (rings - 1);
    // the membrane, or the roof if that is higher, so that the two scalae never intersect
    mirror = std::max(scala.section(angle).roofHeight, scala.membrane_W(angle, 0.5).z());
    for (int k = 0; k < around; ++k) {
      const Eigen::Vector3d wall = scala.wall_W(angle, 2.0 * pi * k / around);
      surface.points.push_back({wall.x(), wall.y(), 2.0 * mirror - wall.z()});
    }
  }
  // mirrored, so the order of corners is opposite to that of the scala tympani
  for (int i = 0; i + 1 < rings; ++i)
    for (int k = 0; k < around; ++k) {
      const int a = i * around + k;
      const int b = i * around + (k + 1) % around;
      surface.triangles.push_back({a, b, a + around});
      surface.triangles.push_back({b, b + around, a + around});
    }
  const int center = static_cast<int>(surface.points.size());
  const int ring = center - around;
  const Eigen::Vector3d apex = scala.center_W(last);
  surface.points.push_back({apex.x(), apex.y(), 2.0 * mirror - apex.z()});
  for (int k = 0; k < around; ++k)
    surface.triangles.push_back({ring + k, ring + (k + 1) % around, center});
  return surface;
}

}  // namespace perilymph::anatomy
