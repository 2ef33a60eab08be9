// SPDX-License-Identifier: BSD-3-Clause
#include "ArraySurface.h"

#include <Eigen/Geometry>
#include <cmath>

#include "perilymph/foundation/Units.h"

namespace perilymph::broadcast {

namespace {

constexpr int sides = 16;
constexpr int capRings = 6;

/// A point of the center line, with its section.
struct Station {
  Eigen::Vector3d place_W, along_W;   ///< [m]; unit, toward the tip.
  double within = 0.0, across = 0.0;  ///< Half the diameters [m].
};

Eigen::Vector3d node(const BroadcastFrame& frame, std::uint32_t i)
{
  const auto& place = frame.node_W[i];
  return Eigen::Vector3d(place[0], place[1], place[2]);
}

Eigen::Vector3d direction(const Eigen::Vector3d& vector)
{
  const double length = vector.norm();
  return length > 0.0 ? Eigen::Vector3d(vector / length)
                      : Eigen::Vector3d(Eigen::Vector3d::UnitZ());
}

Station atNode(const BroadcastFrame& frame, std::uint32_t i)
{
  const std::uint32_t before = i > 0 ? i - 1 : 0, after = std::min(i + 1, frame.nodes - 1);
  return {node(frame, i), direction(node(frame, after) - node(frame, before)),
          frame.halfWidth[i][0], frame.halfWidth[i][1]};
}

/// The station at a distance from the tip, at most the array's length.
Station fromTip(const BroadcastFrame& frame, double distance)
{
  std::uint32_t end = frame.nodes - 1;
  Eigen::Vector3d step = node(frame, end - 1) - node(frame, end);
  while (end > 1 && step.norm() < distance) {
    distance -= step.norm();
    --end;
    step = node(frame, end - 1) - node(frame, end);
  }
  const double u = step.norm() > 0.0 ? std::min(1.0, distance / step.norm()) : 0.0;
  const auto width = [&](std::size_t k) {
    return (1.0 - u) * frame.halfWidth[end][k] + u * frame.halfWidth[end - 1][k];
  };
  return {node(frame, end) + u * step, direction(-step), width(0), width(1)};
}

/// Adds a ring of points, seen counterclockwise against the direction of the array.
void addRing(anatomy::Surface& surface, const Station& at)
{
  Eigen::Vector3d inner_W(-at.place_W.x(), -at.place_W.y(), 0.0);  // toward the modiolar axis
  inner_W -= inner_W.dot(at.along_W) * at.along_W;
  if (inner_W.norm() < 1e-9)
    inner_W = at.along_W.unitOrthogonal();  // [m]; no side is the inner one
  inner_W.normalize();
  const Eigen::Vector3d beside_W = at.along_W.cross(inner_W);
  for (int k = 0; k < sides; ++k) {
    const double angle = 2.0 * pi * k / sides;
    const Eigen::Vector3d point =
        at.place_W + at.within * std::cos(angle) * inner_W + at.across * std::sin(angle) * beside_W;
    surface.points.push_back({point.x(), point.y(), point.z()});
  }
}

/// Closes the surface between its last ring, or its first one, and a point.
void addFan(anatomy::Surface& surface, const Eigen::Vector3d& middle_W, int firstOfRing,
            bool isAtTip)
{
  const int middle = static_cast<int>(surface.points.size());
  surface.points.push_back({middle_W.x(), middle_W.y(), middle_W.z()});
  for (int k = 0; k < sides; ++k) {
    const int a = firstOfRing + k, b = firstOfRing + (k + 1) % sides;
    surface.triangles.push_back(isAtTip ? std::array<int, 3>{a, b, middle}
                                        : std::array<int, 3>{b, a, middle});
  }
}

}  // namespace

anatomy::Surface arraySurface(const BroadcastFrame& frame)
{
  anatomy::Surface surface;
  if (frame.nodes < 2) return surface;
  const std::uint32_t last = frame.nodes - 1;
  const double cap = frame.halfWidth[last][0];
  if (!(cap > 0.0)) return surface;

  // From the base to the cap, then the cap's rings, which are those of half an ellipsoid.
  double left = 0.0;  // along the nodes to the tip [m]
  for (std::uint32_t i = last; i > 0; --i) left += (node(frame, i) - node(frame, i - 1)).norm();
  int rings = 0;
  for (std::uint32_t i = 0; i < last && (i == 0 || left > 1.001 * cap); ++i) {
    addRing(surface, atNode(frame, i));
    ++rings;
    left -= (node(frame, i + 1) - node(frame, i)).norm();
  }
  for (int i = capRings; i > 0; --i) {
    const double angle = 0.5 * pi * i / capRings;  // 0 at the tip
    Station at = fromTip(frame, cap * (1.0 - std::cos(angle)));
    at.within *= std::sin(angle);
    at.across *= std::sin(angle);
    addRing(surface, at);
    ++rings;
  }
  for (int ring = 0; ring + 1 < rings; ++ring)
    for (int k = 0; k < sides; ++k) {
      const int a = ring * sides + k, b = ring * sides + (k + 1) % sides;
      surface.triangles.push_back({a, b, a + sides});
      surface.triangles.push_back({b, b + sides, a + sides});
    }
  addFan(surface, node(frame, last), (rings - 1) * sides, true);
  addFan(surface, node(frame, 0), 0, false);
  return surface;
}

}  // namespace perilymph::broadcast
