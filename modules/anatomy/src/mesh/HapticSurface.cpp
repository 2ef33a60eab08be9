// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/anatomy/HapticSurface.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace perilymph::anatomy {
namespace {

constexpr Angle end = degrees(720.0);
/// Corners of a ring. With 14, the chord errors around and along the duct are about equal.
constexpr int corners = 14;
/// Candidate directions of a corner.
constexpr int candidateDirections = 112;

double directionOf(int index) { return 2.0 * pi * index / candidateDirections; }

/// Angles from the round window to `end` at which straight edges have equal chord errors: an edge
/// of length s on a wall of radius r has the error s^2 / (8 r), so s is proportional to sqrt(r).
std::vector<double> ringAngles(const ScalaTympani& scala, int rings)
{
  constexpr int fine = 2000;
  const double step = std::min(end.si(), scala.lastAngle().si()) / fine;
  std::vector<double> fraction{0.0};
  for (int i = 1; i <= fine; ++i) {
    const Eigen::Vector3d before_W = scala.wall_W((i - 1) * step, 0.0);
    const Eigen::Vector3d here_W = scala.wall_W(i * step, 0.0);
    const double radius = std::sqrt(here_W.x() * here_W.x() + here_W.y() * here_W.y());
    fraction.push_back(fraction.back() + (here_W - before_W).norm() / std::sqrt(radius));
  }

  std::vector<double> angles;
  std::size_t at = 1;
  for (int i = 0; i < rings; ++i) {
    const double wanted = fraction.back() * i / (rings - 1);
    while (at < fine && fraction[at] < wanted) ++at;
    const double beyond = (wanted - fraction[at - 1]) / (fraction[at] - fraction[at - 1]);
    angles.push_back(step * (static_cast<double>(at - 1) + beyond));
  }
  return angles;
}

double distanceToEdge(const Eigen::Vector3d& point, const Eigen::Vector3d& from,
                      const Eigen::Vector3d& to)
{
  const Eigen::Vector3d edge = to - from;
  const double fraction = std::clamp((point - from).dot(edge) / edge.squaredNorm(), 0.0, 1.0);
  return (point - from - fraction * edge).norm();
}

/// The direction between two corners at which the outlines deviate most from the edge between them.
struct Bulge {
  int direction = -1;
  double height = 0.0;  ///< [m]
};

Bulge greatestBulge(const std::vector<std::vector<Eigen::Vector3d>>& outlines, int from, int to)
{
  Bulge greatest;
  for (int k = from + 1; k < to; ++k)
    for (const auto& outline : outlines) {
      const auto at = [&outline](int i) {
        return outline[static_cast<std::size_t>(i % candidateDirections)];
      };
      const double height = distanceToEdge(at(k), at(from), at(to));
      if (height > greatest.height) greatest = {k, height};
    }
  return greatest;
}

/// The directions of the corners, equal for all rings, increasing from zero to less than one turn.
std::vector<int> cornerDirections(const std::vector<std::vector<Eigen::Vector3d>>& outlines)
{
  std::vector<int> chosen{0, candidateDirections / 4, 2 * candidateDirections / 4,
                          3 * candidateDirections / 4};
  while (static_cast<int>(chosen.size()) < corners) {
    Bulge greatest;
    for (std::size_t i = 0; i < chosen.size(); ++i) {
      const int to = i + 1 < chosen.size() ? chosen[i + 1] : chosen[0] + candidateDirections;
      const Bulge bulge = greatestBulge(outlines, chosen[i], to);
      if (bulge.height > greatest.height) greatest = bulge;
    }
    if (greatest.direction < 0) break;
    chosen.insert(std::upper_bound(chosen.begin(), chosen.end(), greatest.direction),
                  greatest.direction);
  }
  return chosen;
}

}  // namespace

Surface hapticSurface(const ScalaTympani& scala)
{
  constexpr int rings = hapticTriangles / (2 * corners);  // one more at the opening
  std::vector<double> angles = ringAngles(scala, rings);
  std::vector<std::vector<Eigen::Vector3d>> outlines;
  for (const double angle : angles) {
    auto& outline = outlines.emplace_back();
    for (int k = 0; k < candidateDirections; ++k)
      outline.push_back(scala.wall_W(angle, directionOf(k)));
  }
  const std::vector<int> chosen = cornerDirections(outlines);
  angles.insert(angles.begin(), -1.0);

  Surface surface;
  for (const double angle : angles)
    for (const int k : chosen) {
      const Eigen::Vector3d place = scala.wall_W(angle, directionOf(k));
      surface.points.push_back({place.x(), place.y(), place.z()});
    }
  const int around = static_cast<int>(chosen.size());
  for (int i = 0; i + 1 < static_cast<int>(angles.size()); ++i)
    for (int k = 0; k < around; ++k) {
      const int a = i * around + k;
      const int b = i * around + (k + 1) % around;
      // split a skew quadrilateral along its shorter diagonal
      const auto far = [&](int p, int q) {
        const auto& u = surface.points[static_cast<std::size_t>(p)];
        const auto& v = surface.points[static_cast<std::size_t>(q)];
        return (Eigen::Vector3d(u[0], u[1], u[2]) - Eigen::Vector3d(v[0], v[1], v[2]))
            .squaredNorm();
      };
      if (far(a, b + around) < far(b, a + around)) {
        surface.triangles.push_back({a, a + around, b + around});
        surface.triangles.push_back({a, b + around, b});
      } else {
        surface.triangles.push_back({a, a + around, b});
        surface.triangles.push_back({b, a + around, b + around});
      }
    }
  return surface;
}

}  // namespace perilymph::anatomy
