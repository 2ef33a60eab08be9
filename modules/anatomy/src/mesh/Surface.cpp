// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/anatomy/Surface.h"

#include <algorithm>
#include <cmath>

#include "perilymph/foundation/Math.h"

namespace perilymph::anatomy {
namespace {

std::array<double, 3> corner(const Eigen::Vector3d& point)
{
  return {point.x(), point.y(), point.z()};
}

/// The angles of the rings: the opening, then from the round window to the apex at equal arc
/// lengths along the outer wall, so that the wide basal turn is as smooth as the narrow apical one.
std::vector<double> ringAngles(const ScalaTympani& scala, int rings)
{
  constexpr std::size_t fine = 4000;
  const double step = scala.lastAngle().si() / fine;
  std::vector<double> length(fine + 1, 0.0);
  for (std::size_t i = 1; i <= fine; ++i) {
    const auto angle = static_cast<double>(i) * step;
    length[i] = length[i - 1] + (scala.wall_W(angle, 0.0) - scala.wall_W(angle - step, 0.0)).norm();
  }

  std::vector<double> angles{-1.0};
  std::size_t at = 1;
  for (int i = 0; i + 1 < rings; ++i) {
    const double wanted = length.back() * i / (rings - 2);
    while (at < fine && length[at] < wanted) ++at;
    const double fraction = (wanted - length[at - 1]) / (length[at] - length[at - 1]);
    angles.push_back(step * (static_cast<double>(at - 1) + fraction));
  }
  return angles;
}

/// Rings of a wall with a limited number of triangles: the opening, then from the round window to
/// the apex, and the corners of each ring. About six times as many rings as corners per ring,
/// because the duct is long.
struct Rings {
  std::vector<double> angles;
  int around;
};

Rings ringsOf(const ScalaTympani& scala, int maxTriangles)
{
  const int maximum = std::max(maxTriangles, 200);
  const int around = std::max(8, static_cast<int>(std::sqrt(maximum / 12.0)));
  const int rings = std::max(4, (maximum - around) / (2 * around) + 1);
  return {ringAngles(scala, rings), around};
}

/// The wall between rings, open at both ends.
Surface tube(const ScalaTympani& scala, const std::vector<double>& angles, int around)
{
  Surface surface;
  for (const double angle : angles)
    for (int k = 0; k < around; ++k)
      surface.points.push_back(corner(scala.wall_W(angle, 2.0 * pi * k / around)));
  for (int i = 0; i + 1 < static_cast<int>(angles.size()); ++i)
    for (int k = 0; k < around; ++k) {
      const int a = i * around + k;
      const int b = i * around + (k + 1) % around;
      surface.triangles.push_back({a, a + around, b});
      surface.triangles.push_back({b, a + around, b + around});
    }
  return surface;
}

/// A point of the basilar membrane; toward the apex, where the ribbon of the tables is wider than the
/// lumen, its edge is the wall.
Eigen::Vector3d membraneInside(const ScalaTympani& scala, double angle, double across)
{
  const Eigen::Vector3d center = scala.center_W(angle);
  const Eigen::Vector3d out = scala.membrane_W(angle, across) - center;
  const SineCosine turn = sineCosine(angle);
  const double radial = out.dot(Eigen::Vector3d(turn.cosine, turn.sine, 0.0));
  const Eigen::Vector3d toWall = scala.wall_W(angle, arcTangent(out.z(), radial)) - center;
  return center + std::min(1.0, toWall.norm() / out.norm()) * out;
}

}  // namespace

Surface wallSurface(const ScalaTympani& scala, int maxTriangles)
{
  const Rings cut = ringsOf(scala, maxTriangles);
  Surface surface = tube(scala, cut.angles, cut.around);

  // the apex is closed by a triangle fan around the last section's center
  const int center = static_cast<int>(surface.points.size());
  const int ring = center - cut.around;
  surface.points.push_back(corner(scala.center_W(scala.lastAngle().si())));
  for (int k = 0; k < cut.around; ++k)
    surface.triangles.push_back({ring + k, center, ring + (k + 1) % cut.around});
  return surface;
}

Surface wallSurfaceBefore(const ScalaTympani& scala, int maxTriangles, Angle end)
{
  Rings cut = ringsOf(scala, maxTriangles);
  while (cut.angles.size() > 2 && cut.angles.back() > end.si()) cut.angles.pop_back();
  return tube(scala, cut.angles, cut.around);
}

Surface membraneSurface(const ScalaTympani& scala, int maxTriangles)
{
  const int rings = std::max(4, maxTriangles / 2 + 1);
  Surface surface;
  for (int i = 0; i < rings; ++i) {
    const double angle = scala.lastAngle().si() * i / (rings - 1);
    surface.points.push_back(corner(membraneInside(scala, angle, 0.0)));
    surface.points.push_back(corner(membraneInside(scala, angle, 1.0)));
  }
  for (int i = 0; i + 1 < rings; ++i) {
    surface.triangles.push_back({2 * i, 2 * i + 1, 2 * i + 2});
    surface.triangles.push_back({2 * i + 1, 2 * i + 3, 2 * i + 2});
  }
  return surface;
}

}  // namespace perilymph::anatomy
