#pragma once

// How far a point is from a surface of triangles, and where the nearest place on it is.

#include <Eigen/Core>
#include <vector>

#include "perilymph/anatomy/Surface.h"

namespace perilymph::anatomy {

/// The weights of the corners a, b, c in the place of their triangle nearest to a point, by the
/// region of the triangle's plane in which the point's projection lies (Ericson, Real-Time
/// Collision Detection, section 5.1.5). Real-time safe.
Eigen::Vector3d barycentricWeights(const Eigen::Vector3d& point, const Eigen::Vector3d& a,
                                   const Eigen::Vector3d& b, const Eigen::Vector3d& c) noexcept;

/// The place on a surface nearest to a point.
struct SurfaceFoot {
  int triangle = -1;                                  ///< -1 where nothing lies within reach.
  double distance = 0.0;                              ///< From the point [m], 0 or more.
  Eigen::Vector3d place = Eigen::Vector3d::Zero();    ///< On the surface [m].
  Eigen::Vector3d weights = Eigen::Vector3d::Zero();  ///< Barycentric weights of that place.
};

/// A surface sorted into a tree of boxes, for many questions. Keeps a copy of its triangles.
class SurfaceDistance {
public:
  explicit SurfaceDistance(const Surface& surface);

  /// The nearest place within `reach` [m] of a point.
  SurfaceFoot nearest(const Eigen::Vector3d& point, double reach = 1.0) const noexcept;

private:
  struct Corners {
    Eigen::Vector3d a, b, c;
  };
  /// A box around triangles `first` to `first + count`, or around two boxes: the next in the list
  /// and the one at `second`.
  struct Box {
    Eigen::Vector3d low, high;
    int first = 0, count = 0, second = 0;
  };
  int divide(int first, int count);

  std::vector<Corners> triangles_;  ///< In the order of the boxes.
  std::vector<int> names_;          ///< Index in the surface of each.
  std::vector<Box> boxes_;
};

}  // namespace perilymph::anatomy
