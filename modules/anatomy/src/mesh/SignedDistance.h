// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Signed distance to a closed surface.

#include <array>
#include <vector>

#include "perilymph/anatomy/SurfaceDistance.h"

namespace perilymph::anatomy {

/// The side of a point follows from the angle-weighted mean normal of the nearest triangle, edge or
/// corner, which is correct for every closed surface that faces outward (Baerentzen and Aanaes
/// 2005).
class SignedDistance {
public:
  explicit SignedDistance(const Surface& closed);

  /// Signed distance, positive inside [m]; `beyond`, negative, for points outside and farther than
  /// `reach`. `reach` must be larger than the maximum depth inside.
  double at(const Eigen::Vector3d& point, double reach, double beyond) const noexcept;

private:
  SurfaceDistance nearest_;
  std::vector<std::array<int, 3>> triangles_;
  std::vector<Eigen::Vector3d> faces_;                 ///< Unit normal of each triangle.
  std::vector<std::array<Eigen::Vector3d, 3>> edges_;  ///< Per triangle, opposite each corner.
  std::vector<Eigen::Vector3d> corners_;
};

}  // namespace perilymph::anatomy
