#pragma once

// The lines where a surface turns away from the viewer, and its open rim.

#include <Eigen/Core>
#include <vector>

#include "Mesh.h"

namespace perilymph::visualization {

using Polyline = std::vector<Eigen::Vector3d>;

/// Finds silhouettes of a smooth triangle surface: along them its normal is square to the view.
class Silhouette {
public:
  Silhouette(std::vector<Eigen::Vector3d> points, std::vector<Eigen::Vector3d> normals,
             std::vector<Triangle> triangles);

  /// The silhouettes seen from far away in the direction `back`, as chains of points; those shorter
  /// than `shortest_mm` are left out.
  std::vector<Polyline> lines(const Eigen::Vector3d& back, double shortest_mm) const;
  /// The edges that belong to one triangle only, as chains.
  std::vector<Polyline> rims() const;

private:
  struct Edge {
    int from, to;
    int triangle[2] = {-1, -1};
  };
  void walk(int triangle, int edge, const std::vector<double>& facing,
            std::vector<unsigned char>& isDone, Polyline& line) const;
  Eigen::Vector3d crossing(int edge, const std::vector<double>& facing) const;

  std::vector<Eigen::Vector3d> points_, normals_;
  std::vector<Triangle> triangles_;
  std::vector<Edge> edges_;
  std::vector<std::array<int, 3>> edgesOf_;  ///< Edges of each triangle.
};

/// Normals at the points of a surface: the mean of the triangles around, by their angle-free area.
std::vector<Eigen::Vector3d> pointNormals(const std::vector<Eigen::Vector3d>& points,
                                          const std::vector<Triangle>& triangles);

}  // namespace perilymph::visualization
