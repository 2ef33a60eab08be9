// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The haptic surface: collision of spherical proxies with triangles.

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

#include "perilymph/anatomy/Surface.h"

namespace perilymph::mechanics {

class HalfSpaces;

/// Position of a proxy, and the constraint of the surface on it.
struct ProxyHold {
  Eigen::Vector3d place_W;  ///< The sphere's center [m].
  /// From the goal to the nearest allowed position, along the surface's force [m]. Zero if the goal
  /// is allowed.
  Eigen::Vector3d pressed_W;
  bool touches = false;
};

/// Triangles that face into a lumen, sorted into a grid. Immutable; every query is real-time safe.
///
/// A proxy is a sphere (the god object of Zilles and Salisbury 1995, with a radius as of Ruspini
/// 1997): it moves as near to its goal as the surface allows, and never through it. Each triangle
/// within reach defines one half-space, at a distance of the sphere's radius from its point nearest
/// to the proxy; inside their intersection the proxy moves to the position nearest to its goal, by
/// at most `reach`, and the triangles are searched again. The proxy is the only state: it stays on
/// its side of the surface, however far beyond the goal is. Triangles seen from behind do not
/// constrain it, nor does an edge or a corner shared with such a triangle: these belong to a
/// neighboring turn, seen from outside. Where turns intersect, as those of the published anatomy do
/// beyond 200 degrees, a proxy may be caught between their walls.
/// proxy may be caught between their walls.
class ProxySurface {
public:
  /// Minimum search distance of a proxy beyond its own surface [m].
  static constexpr double reach = 0.1e-3;
  static constexpr int maxMoves = 16;

  /// @param maxRadius  Maximum radius of the proxies [m].
  /// @throws std::invalid_argument with a message for a surface without triangles, with corners
  ///         that are not finite, or larger than a cochlea can be.
  ProxySurface(const anatomy::Surface& surface, double maxRadius);

  /// Moves a proxy toward its goal. A goal farther than `maxMoves` times `reach` is approached over
  /// several calls. Real-time safe.
  ///
  /// @param allowed  Workspace for the constraints near the proxy.
  ProxyHold follow(const Eigen::Vector3d& proxy_W, const Eigen::Vector3d& goal_W, double radius,
                   HalfSpaces& allowed) const noexcept;

  std::size_t triangles() const noexcept { return triangles_.size(); }
  /// Fingerprint of all data above, as part of the model's.
  std::uint64_t fingerprint() const noexcept { return fingerprint_; }

private:
  struct Triangle {
    Eigen::Vector3d a, b, c;
    Eigen::Vector3d inward;      ///< Unit.
    std::array<int, 3> corners;  ///< Their indices.
    std::array<int, 3> across;   ///< Neighbor across the edge opposite a, b, c; -1: none.
  };
  void findNeighbors(std::size_t corners);
  bool isInFrontOf(const Eigen::Vector3d& place_W, int triangle) const noexcept;
  bool sees(const Eigen::Vector3d& place_W, const Triangle& triangle,
            const Eigen::Vector3d& weights) const noexcept;
  std::size_t cellOf(const Eigen::Vector3d& place_W) const noexcept;
  void gather(const Eigen::Vector3d& proxy_W, double radius, HalfSpaces& allowed) const noexcept;

  double maxRadius_;
  std::vector<Triangle> triangles_;
  std::vector<int> firstAround_;  ///< First entry of each corner in around_; one more at the end.
  std::vector<int> around_;       ///< Triangles that meet in each corner.
  Eigen::Vector3d low_W_ = Eigen::Vector3d::Zero();
  double cell_ = 0.0;        ///< Width of a cell [m].
  int size_[3] = {0, 0, 0};  ///< Cells along each axis.
  std::vector<int> first_;   ///< First entry of each cell in inCell_; one more at the end.
  std::vector<int> inCell_;  ///< Triangles within reach of each cell.
  std::uint64_t fingerprint_ = 0;
};

}  // namespace perilymph::mechanics
