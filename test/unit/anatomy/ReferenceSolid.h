// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The published solid of the mean scala tympani in the frame W, where it is available.

#include <Eigen/Core>
#include <array>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace perilymph::test {

/// Triangles of st_mean_2024/st_mean_model_mm.stl below the folder that the environment variable
/// PERILYMPH_REFERENCE_DATA names.
class ReferenceSolid {
public:
  static bool isThere();
  static std::string whyNot();

  ReferenceSolid();

  /// Corners of its triangles in W [m], each once.
  const std::vector<Eigen::Vector3d>& points() const { return points_; }
  /// Distance from a point to its surface [m]; 1 where that is above 0.4 mm.
  double distance(const Eigen::Vector3d& point) const;

private:
  using Cell = std::array<long, 3>;
  static Cell cellOf(const Eigen::Vector3d& point);

  std::vector<Eigen::Vector3d> points_;
  std::vector<std::array<Eigen::Vector3d, 3>> triangles_;
  std::map<Cell, std::vector<std::size_t>> cells_;
};

}  // namespace perilymph::test
