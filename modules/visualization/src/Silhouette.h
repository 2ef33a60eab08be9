// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Silhouettes and open rims of a surface.

#include <Eigen/Core>
#include <vector>

#include "Mesh.h"

namespace perilymph::visualization {

using Polyline = std::vector<Eigen::Vector3d>;

/// Finds silhouettes of a smooth triangle surface, where the normal is perpendicular to the view.
class Silhouette {
public:
  Silhouette(std::vector<Eigen::Vector3d> points, std::vector<Eigen::Vector3d> normals,
             std::vector<Triangle> triangles);

  /// The silhouettes seen from infinity in the direction `back`, as polylines; those shorter than
  /// `shortest_mm` are omitted.
  std::vector<Polyline> lines(const Eigen::Vector3d& back, double shortest_mm) const;
  /// The edges that belong to only one triangle, as polylines.
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

/// Vertex normals of a surface: the area-weighted mean of adjacent triangles.
std::vector<Eigen::Vector3d> pointNormals(const std::vector<Eigen::Vector3d>& points,
                                          const std::vector<Triangle>& triangles);

}  // namespace perilymph::visualization
