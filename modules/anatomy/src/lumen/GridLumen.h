// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// A lumen of arbitrary shape: signed distance to its wall on a spatial grid.

#include <vector>

#include "perilymph/anatomy/Lumen.h"
#include "perilymph/anatomy/Surface.h"

namespace perilymph::anatomy {

/// A lumen whose wall is a triangle surface without section tables.
///
/// Signed distances at 0.05 mm spacing are the coefficients of a tricubic B-spline: the distance
/// has continuous second derivatives even along ridges, which are rounded over one grid step. The
/// angle of a point is counted about the z axis of W. A surface does not contain the location of
/// the basilar membrane: `onMembrane` is always false.
class GridLumen final : public Lumen {
public:
  static constexpr double spacing = 0.05e-3;  ///< [m]

  /// @param wall    The wall in W, open at the opening, facing outward.
  /// @param closed  The same, closed by a lid over the opening.
  /// @param entry   The opening. Points behind its plane in the first quarter turn have no wall
  /// nearby.
  ///
  /// Takes seconds and about 10 MB; not real-time safe.
  GridLumen(const Surface& wall, const Surface& closed, const Entry& entry);

  Entry entry() const noexcept override { return entry_; }
  LumenTrack startTrack() const noexcept override { return {}; }
  void nearestWall(std::span<const Eigen::Vector3d> points_W, std::span<const double> reach,
                   std::span<LumenTrack> tracks,
                   std::span<WallPoint> walls) const noexcept override;
  void follow(const Eigen::Vector3d& point_W, LumenTrack& track) const noexcept override;
  void addTo(Hash& hash) const noexcept override;

private:
  /// Updates the track. False outside.
  bool track(const Eigen::Vector3d& point_W, LumenTrack& track) const noexcept;
  void locate(const Eigen::Vector3d& point_W, double reach, LumenTrack& memory,
              WallPoint& wall) const noexcept;

  Entry entry_;
  Eigen::Vector3d low_W_;        ///< Position of the first sample.
  int size_[3] = {0, 0, 0};      ///< Samples along each axis.
  std::vector<float> distance_;  ///< [x][y][z], [m].
};

}  // namespace perilymph::anatomy
