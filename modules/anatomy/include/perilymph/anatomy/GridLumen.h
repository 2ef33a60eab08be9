#pragma once

// A lumen of any shape: signed distances to its wall on a grid in space.

#include <vector>

#include "perilymph/anatomy/Lumen.h"
#include "perilymph/anatomy/Surface.h"

namespace perilymph::anatomy {

/// The wall of a surface that no tables describe, behind the same question as every other lumen.
///
/// Signed distances 0.05 mm apart are the coefficients of a tricubic B-spline: the distance has
/// continuous second derivatives even along ridges, which are rounded over one step of the grid.
/// The angle of a point is followed about the z axis of W. Where the basilar membrane is, a surface
/// does not tell: `onMembrane` is always false.
class GridLumen final : public Lumen {
public:
  static constexpr double spacing = 0.05e-3;  ///< [m]

  /// @param wall    The wall in W, open at the opening, facing outward.
  /// @param closed  The same with a lid over the opening.
  /// @param entry   The opening. Points behind its plane in the first quarter turn see no wall.
  ///
  /// Takes seconds and some 10 MB; not real-time safe.
  GridLumen(const Surface& wall, const Surface& closed, const Entry& entry);

  Entry entry() const noexcept override { return entry_; }
  LumenTrack startTrack() const noexcept override { return {}; }
  void nearestWall(std::span<const Eigen::Vector3d> points_W, std::span<const double> reach,
                   std::span<LumenTrack> tracks,
                   std::span<WallPoint> walls) const noexcept override;

private:
  void locate(const Eigen::Vector3d& point_W, double reach, LumenTrack& track,
              WallPoint& wall) const noexcept;

  Entry entry_;
  Eigen::Vector3d low_W_;        ///< Place of the first sample.
  int size_[3] = {0, 0, 0};      ///< Samples each way.
  std::vector<float> distance_;  ///< [x][y][z], [m].
};

}  // namespace perilymph::anatomy
