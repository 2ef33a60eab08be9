// SPDX-License-Identifier: BSD-3-Clause
#include "ArrayPath.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace perilymph::visualization {

ArrayPath::ArrayPath(Length length) : length_mm_(inMillimeters(length))
{
  nodes_.reserve(mechanics::maxNodes);
}

void ArrayPath::follow(const haptics::Snapshot& now, const PictureSpace& space)
{
  nodes_.clear();
  const std::uint32_t count = std::min<std::uint32_t>(now.nodes, mechanics::maxNodes);
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::array<float, 3>& node = now.node_W[i];
    const Eigen::Vector3d place_W(node[0], node[1], node[2]);
    if (!place_W.allFinite()) {  // a fault: nothing valid to show
      nodes_.clear();
      return;
    }
    nodes_.push_back(space.place(place_W));
  }
}

void ArrayPath::follow(std::span<const Eigen::Vector3d> nodes_W, const PictureSpace& space)
{
  nodes_.clear();
  const bool isFinite = std::all_of(nodes_W.begin(), nodes_W.end(),
                                    [](const Eigen::Vector3d& node) { return node.allFinite(); });
  if (!isFinite) return;
  for (const Eigen::Vector3d& node_W : nodes_W) nodes_.push_back(space.place(node_W));
}

PathPoint ArrayPath::at(double fromTip_mm) const
{
  const int last = static_cast<int>(nodes_.size()) - 1;
  const double inside = std::clamp(fromTip_mm, 0.0, length_mm_);
  const double position = length_mm_ > 0.0 ? (1.0 - inside / length_mm_) * last : 0.0;
  const int edge = std::clamp(static_cast<int>(position), 0, last - 1);
  const double u = position - edge;

  // Beyond the ends, nodes are mirrored, so that the curve ends straight.
  const auto node = [&](int i) -> Eigen::Vector3d {
    if (i < 0) return 2.0 * nodes_.front() - nodes_[1];
    if (i > last) return 2.0 * nodes_.back() - nodes_[static_cast<std::size_t>(last - 1)];
    return nodes_[static_cast<std::size_t>(i)];
  };
  const Eigen::Vector3d a = node(edge - 1), b = node(edge), c = node(edge + 1), d = node(edge + 2);
  const Eigen::Vector3d linear = 0.5 * (c - a);
  const Eigen::Vector3d square = 0.5 * (2.0 * a - 5.0 * b + 4.0 * c - d);
  const Eigen::Vector3d cube = 0.5 * (3.0 * (b - c) + d - a);
  const Eigen::Vector3d place = b + u * (linear + u * (square + u * cube));
  const Eigen::Vector3d tangent = linear + u * (2.0 * square + 3.0 * u * cube);
  const double speed = tangent.norm();
  const Eigen::Vector3d along =
      speed > 1e-12 ? Eigen::Vector3d(tangent / speed) : Eigen::Vector3d(Eigen::Vector3d::UnitX());
  return withFrame(place + (inside - fromTip_mm) * along, along);
}

PathPoint ArrayPath::withFrame(const Eigen::Vector3d& place, const Eigen::Vector3d& along) const
{
  const Eigen::Vector3d toAxis(-place.x(), -place.y(), 0.0);
  Eigen::Vector3d inner = toAxis - toAxis.dot(along) * along;
  if (inner.norm() < 1e-6 * (1.0 + toAxis.norm())) {
    // pointing straight at the modiolus: any perpendicular direction will do
    inner = Eigen::Vector3d::UnitZ() - along.z() * along;
    if (inner.norm() < 1e-6) inner = Eigen::Vector3d::UnitX();
  }
  inner.normalize();
  return {place, along, inner, along.cross(inner)};
}

}  // namespace perilymph::visualization
