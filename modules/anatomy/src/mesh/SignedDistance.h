#pragma once

// Distance to a closed surface with the side a point is on.

#include <array>
#include <vector>

#include "perilymph/anatomy/SurfaceDistance.h"

namespace perilymph::anatomy {

/// The side is told by the angle-weighted mean normal of the triangle, edge or corner that is
/// nearest, which is right for every closed surface that faces outward (Baerentzen and Aanaes
/// 2005).
class SignedDistance {
public:
  explicit SignedDistance(const Surface& closed);

  /// Positive inside [m]; `beyond`, negative, for points outside and farther than `reach`, positive
  /// `reach` cannot be told from it and must be larger than the greatest depth inside.
  double at(const Eigen::Vector3d& point, double reach, double beyond) const noexcept;

private:
  SurfaceDistance nearest_;
  std::vector<std::array<int, 3>> triangles_;
  std::vector<Eigen::Vector3d> faces_;                 ///< Unit normal of each triangle.
  std::vector<std::array<Eigen::Vector3d, 3>> edges_;  ///< Per triangle, across from each corner.
  std::vector<Eigen::Vector3d> corners_;
};

}  // namespace perilymph::anatomy
