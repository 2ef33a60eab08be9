#include "perilymph/anatomy/Surface.h"

#include <algorithm>
#include <cmath>

namespace perilymph::anatomy {
namespace {

std::array<double, 3> corner(const Eigen::Vector3d& point)
{
  return {point.x(), point.y(), point.z()};
}

/// The angles at which rings are cut: the opening, then from the round window to the apex.
std::vector<double> ringAngles(const ScalaTympani& scala, int rings)
{
  std::vector<double> angles{-1.0};
  for (int i = 0; i + 1 < rings; ++i) angles.push_back(scala.lastAngle().si() * i / (rings - 2));
  return angles;
}

}  // namespace

Surface wallSurface(const ScalaTympani& scala, int mostTriangles)
{
  // about three times as many rings as a ring has corners: the duct is long
  const int around = std::max(8, static_cast<int>(std::sqrt(std::max(mostTriangles, 200) / 6.0)));
  const int rings = std::max(4, (std::max(mostTriangles, 200) - around) / (2 * around) + 1);

  Surface surface;
  for (const double angle : ringAngles(scala, rings))
    for (int k = 0; k < around; ++k)
      surface.points.push_back(corner(scala.wall_W(angle, 2.0 * pi * k / around)));
  for (int i = 0; i + 1 < rings; ++i)
    for (int k = 0; k < around; ++k) {
      const int a = i * around + k;
      const int b = i * around + (k + 1) % around;
      surface.triangles.push_back({a, a + around, b});
      surface.triangles.push_back({b, a + around, b + around});
    }

  // the apex is closed by a fan around the last section's center
  const int center = static_cast<int>(surface.points.size());
  surface.points.push_back(corner(scala.center_W(scala.lastAngle().si())));
  for (int k = 0; k < around; ++k) {
    const int ring = (rings - 1) * around;
    surface.triangles.push_back({ring + k, center, ring + (k + 1) % around});
  }
  return surface;
}

Surface membraneSurface(const ScalaTympani& scala, int mostTriangles)
{
  const int rings = std::max(4, mostTriangles / 2 + 1);
  Surface surface;
  for (int i = 0; i < rings; ++i) {
    const double angle = scala.lastAngle().si() * i / (rings - 1);
    surface.points.push_back(corner(scala.membrane_W(angle, 0.0)));
    surface.points.push_back(corner(scala.membrane_W(angle, 1.0)));
  }
  for (int i = 0; i + 1 < rings; ++i) {
    surface.triangles.push_back({2 * i, 2 * i + 1, 2 * i + 2});
    surface.triangles.push_back({2 * i + 1, 2 * i + 3, 2 * i + 2});
  }
  return surface;
}

}  // namespace perilymph::anatomy
