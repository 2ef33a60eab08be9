#pragma once

// The haptic surface as a point-set hand feels it: spheres that it does not let through.

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

#include "perilymph/anatomy/Surface.h"

namespace perilymph::mechanics {

class HalfSpaces;

/// Where a proxy stands, and how the surface holds it there.
struct ProxyHold {
  Eigen::Vector3d place_W;  ///< The sphere's center [m].
  /// From the goal to the nearest place that the surface allows: along the surface's push [m]. Zero
  /// where the goal is allowed.
  Eigen::Vector3d pressed_W;
  bool touches = false;
};

/// Triangles that face into a lumen, sorted into a grid. Immutable; every question is real-time
/// safe.
///
/// A proxy is a sphere (the god object of Zilles and Salisbury 1995, with a size as Ruspini 1997
/// gave it one): it goes as near to its goal as the surface lets it, and never through. Each
/// triangle in reach allows one half-space, bounded at the sphere's radius from its place nearest
/// to the proxy; inside all of them the proxy moves to the place nearest to its goal, by at most
/// `reach`, and looks again. The proxy itself is the memory: it stays on the sheet it is on,
/// however far beyond it the goal is. Triangles seen from behind do not hold it, nor do an
/// edge or a corner of which another triangle is: that is a neighboring turn, from outside.
/// Where turns run into each other, as those of the published anatomy do beyond 200 degrees, a
/// proxy may be caught between their walls.
class ProxySurface {
public:
  /// A proxy looks at least so far ahead of its own surface [m].
  static constexpr double reach = 0.1e-3;
  static constexpr int maxMoves = 16;

  /// @param maxRadius  Of the proxies [m].
  /// @throws std::invalid_argument with a sentence for a surface without triangles, with corners
  ///         that are no numbers, or larger than a cochlea can be.
  ProxySurface(const anatomy::Surface& surface, double maxRadius);

  /// Moves a proxy toward its goal. A goal farther than `maxMoves` times `reach` is approached in
  /// several calls. Real-time safe.
  ///
  /// @param allowed  Memory for what the triangles near the proxy allow it.
  ProxyHold follow(const Eigen::Vector3d& proxy_W, const Eigen::Vector3d& goal_W, double radius,
                   HalfSpaces& allowed) const noexcept;

  std::size_t triangles() const noexcept { return triangles_.size(); }
  /// Fingerprint of everything above, for a model's own.
  std::uint64_t fingerprint() const noexcept { return fingerprint_; }

private:
  struct Triangle {
    Eigen::Vector3d a, b, c;
    Eigen::Vector3d inward;      ///< Unit.
    std::array<int, 3> corners;  ///< Their names.
    std::array<int, 3> across;   ///< Neighbor over the edge that faces a, b, c; -1: none.
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
  int size_[3] = {0, 0, 0};  ///< Cells each way.
  std::vector<int> first_;   ///< First entry of each cell in inCell_; one more at the end.
  std::vector<int> inCell_;  ///< Triangles within reach of each cell.
  std::uint64_t fingerprint_ = 0;
};

}  // namespace perilymph::mechanics
