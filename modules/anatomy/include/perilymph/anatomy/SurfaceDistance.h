// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Distance of a point from a triangle surface, and the nearest point on it.

#include <Eigen/Core>
#include <vector>

#include "perilymph/anatomy/Surface.h"

namespace perilymph::anatomy {

/// Barycentric weights of the point of triangle a, b, c nearest to a point, by the Voronoi region
/// of the point's projection (Ericson, Real-Time Collision Detection, section 5.1.5). Real-time
/// safe.
Eigen::Vector3d barycentricWeights(const Eigen::Vector3d& point, const Eigen::Vector3d& a,
                                   const Eigen::Vector3d& b, const Eigen::Vector3d& c) noexcept;

/// The point of a surface nearest to a given point.
struct SurfaceFoot {
  int triangle = -1;                                  ///< -1 if nothing lies within reach.
  double distance = 0.0;                              ///< From the point [m], 0 or more.
  Eigen::Vector3d place = Eigen::Vector3d::Zero();    ///< Position on the surface [m].
  Eigen::Vector3d weights = Eigen::Vector3d::Zero();  ///< Barycentric weights of that position.
};

/// A bounding-volume tree of a surface, for repeated queries. Keeps a copy of its triangles.
class SurfaceDistance {
public:
  explicit SurfaceDistance(const Surface& surface);

  /// The nearest point within `reach` [m].
  SurfaceFoot nearest(const Eigen::Vector3d& point, double reach = 1.0) const noexcept;

private:
  struct Corners {
    Eigen::Vector3d a, b, c;
  };
  /// Bounding box of triangles `first` to `first + count`, or of two child boxes: the next in the
  /// list and the one at `second`.
  struct Box {
    Eigen::Vector3d low, high;
    int first = 0, count = 0, second = 0;
  };
  int divide(int first, int count);

  std::vector<Corners> triangles_;  ///< In the order of the boxes.
  std::vector<int> names_;          ///< Index of each triangle in the surface.
  std::vector<Box> boxes_;
};

}  // namespace perilymph::anatomy
