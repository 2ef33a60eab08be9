// SPDX-License-Identifier: BSD-3-Clause
#include "mesh/SignedDistance.h"

#include <Eigen/Geometry>
#include <cmath>
#include <map>
#include <utility>

#include "perilymph/foundation/Math.h"

namespace perilymph::anatomy {
namespace {

constexpr double onEdge = 1e-9;  // barycentric weight of a corner below which the point lies on the
                                 // opposite edge

}  // namespace

SignedDistance::SignedDistance(const Surface& closed)
    : nearest_(closed), triangles_(closed.triangles)
{
  const auto at = [&](int index) -> Eigen::Vector3d {
    const auto& p = closed.points[static_cast<std::size_t>(index)];
    return {p[0], p[1], p[2]};
  };
  corners_.assign(closed.points.size(), Eigen::Vector3d::Zero());
  std::map<std::pair<int, int>, Eigen::Vector3d> edges;
  const auto edgeOf = [](int a, int b) { return std::pair{std::min(a, b), std::max(a, b)}; };
  for (const auto& t : triangles_) {
    const Eigen::Vector3d across = (at(t[1]) - at(t[0])).cross(at(t[2]) - at(t[0]));
    const double twice = across.norm();
    const Eigen::Vector3d normal =
        twice > 0.0 ? Eigen::Vector3d(across / twice) : Eigen::Vector3d(Eigen::Vector3d::Zero());
    faces_.push_back(normal);
    for (std::size_t k = 0; k < 3; ++k) {
      const Eigen::Vector3d one = at(t[(k + 1) % 3]) - at(t[k]);
      const Eigen::Vector3d two = at(t[(k + 2) % 3]) - at(t[k]);
      const double angle = arcTangent(one.cross(two).norm(), one.dot(two));
      corners_[static_cast<std::size_t>(t[k])] += angle * normal;
      edges.try_emplace(edgeOf(t[(k + 1) % 3], t[(k + 2) % 3]), Eigen::Vector3d::Zero())
          .first->second += normal;
    }
  }
  for (const auto& t : triangles_)
    edges_.push_back(
        {edges.at(edgeOf(t[1], t[2])), edges.at(edgeOf(t[2], t[0])), edges.at(edgeOf(t[0], t[1]))});
}

double SignedDistance::at(const Eigen::Vector3d& point, double reach, double beyond) const noexcept
{
  const SurfaceFoot foot = nearest_.nearest(point, reach);
  if (foot.triangle < 0) return beyond;
  const auto triangle = static_cast<std::size_t>(foot.triangle);
  int small = 0;
  for (int k = 0; k < 3; ++k)
    if (foot.weights[k] < onEdge) ++small;
  Eigen::Vector3d normal = faces_[triangle];
  for (std::size_t k = 0; k < 3; ++k) {
    const double weight = foot.weights[static_cast<int>(k)];
    if (small == 1 && weight < onEdge) normal = edges_[triangle][k];
    if (small == 2 && weight >= onEdge)
      normal = corners_[static_cast<std::size_t>(triangles_[triangle][k])];
  }
  return (point - foot.place).dot(normal) < 0.0 ? foot.distance : -foot.distance;
}

}  // namespace perilymph::anatomy
