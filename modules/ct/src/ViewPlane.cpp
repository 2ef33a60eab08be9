// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/ct/ViewPlane.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace perilymph::ct {

namespace {

constexpr double smallComponent = 0.2;  // about 12 degrees from a right angle

/// Where the line between two points crosses the plane.
Eigen::Vector2d crossing(const ViewPlane& plane, const Eigen::Vector3d& a_P, double behindA,
                         const Eigen::Vector3d& b_P, double behindB)
{
  const double fraction = behindA / (behindA - behindB);
  return plane.inPicture(a_P + fraction * (b_P - a_P));
}

}  // namespace

std::array<ViewPlane, 3> patientPlanes(const Eigen::Vector3d& center_P)
{
  const Eigen::Vector3d left = Eigen::Vector3d::UnitX(), posterior = Eigen::Vector3d::UnitY(),
                        inferior = -Eigen::Vector3d::UnitZ();
  return {ViewPlane{center_P, left, posterior}, ViewPlane{center_P, left, inferior},
          ViewPlane{center_P, posterior, inferior}};
}

std::array<ViewPlane, 3> cochlearPlanes(const CochleaMeasures& measures,
                                        const Eigen::Vector3d& center_P)
{
  const Eigen::Vector3d toBase = -measures.axis_P;
  const Eigen::Vector3d toWindow = measures.axes_PW.col(0);
  const Eigen::Vector3d across = toWindow.cross(toBase);
  return {ViewPlane{center_P, across, toWindow}, ViewPlane{center_P, toWindow, toBase},
          ViewPlane{center_P, across, toBase}};
}

Eigen::Vector3d basalTurnCenter_P(const CochleaMeasures& measures)
{
  const std::size_t n = measures.wallPointsPerRing;
  const std::size_t rings = n == 0 ? 0 : measures.wall_P.size() / n;
  constexpr std::size_t basalRings = 90;  // of 4 degrees each
  double height = 0.0;
  std::size_t count = 0;
  for (std::size_t k = 0; k < std::min(rings, basalRings) * n; ++k, ++count)
    height += measures.axis_P.dot(measures.wall_P[k] - measures.center_P);
  if (count > 0) height /= static_cast<double>(count);
  return measures.center_P + height * measures.axis_P;
}

std::string directionLetters(const Eigen::Vector3d& direction_P)
{
  std::array<std::pair<double, char>, 3> components{
      std::pair{direction_P.x(), direction_P.x() < 0.0 ? 'R' : 'L'},
      std::pair{direction_P.y(), direction_P.y() < 0.0 ? 'A' : 'P'},
      std::pair{direction_P.z(), direction_P.z() < 0.0 ? 'I' : 'S'}};
  std::ranges::stable_sort(components, [](const auto& one, const auto& other) {
    return std::fabs(one.first) > std::fabs(other.first);
  });
  std::string letters;
  for (const auto& [size, letter] : components)
    if (std::fabs(size) >= smallComponent) letters += letter;
  return letters;
}

std::vector<PictureLine> wallOutline(const CochleaMeasures& measures, const ViewPlane& plane)
{
  std::vector<double> behind;
  behind.reserve(measures.wall_P.size());
  for (const Eigen::Vector3d& point_P : measures.wall_P) behind.push_back(plane.behind(point_P));
  std::vector<PictureLine> lines;
  for (const auto& corners : measures.wallTriangles) {
    std::array<Eigen::Vector2d, 3> ends;
    std::size_t count = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto a = static_cast<std::size_t>(corners[k]);
      const auto b = static_cast<std::size_t>(corners[(k + 1) % 3]);
      if ((behind[a] < 0.0) == (behind[b] < 0.0)) continue;
      ends[count++] = crossing(plane, measures.wall_P[a], behind[a], measures.wall_P[b], behind[b]);
    }
    if (count == 2) lines.push_back({ends[0], ends[1]});
  }
  return lines;
}

}  // namespace perilymph::ct
