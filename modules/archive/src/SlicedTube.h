// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Which voxel centers of a slice lie in a closed tube.

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace perilymph::archive {

/// A slice of a CT: its pixel of row r and column c has its center at `origin + c * acrossStep +
/// r * downStep` [mm].
struct SlicePlane {
  std::array<double, 3> origin{}, acrossStep{}, downStep{};
  int rows = 0, columns = 0;
};

/// The surface of a tube of rings, closed by a fan at each end.
class SlicedTube {
public:
  /// @param points_mm  Ring by ring; a whole number of rings, at least two, of at least three points.
  SlicedTube(const std::vector<std::array<double, 3>>& points_mm, std::size_t pointsPerRing);

  /// A byte for each pixel, row by row: 1 where the surface winds around the center, else 0. Empty if
  /// all are 0.
  std::vector<std::uint8_t> inside(const SlicePlane& slice) const;

private:
  std::vector<std::array<double, 3>> points_mm_;
  std::vector<std::array<std::size_t, 3>> triangles_;
};

}  // namespace perilymph::archive
