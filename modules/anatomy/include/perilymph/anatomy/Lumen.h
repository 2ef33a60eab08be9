#pragma once

// The question the mechanics asks of any anatomy: how far is the wall, and which way is in?

#include <Eigen/Core>
#include <span>

namespace perilymph::anatomy {

/// The opening and the way in: frame E. Right-handed, columns of unit vectors in W.
struct Entry {
  Eigen::Vector3d origin_W = Eigen::Vector3d::Zero();     ///< Center of the opening [m].
  Eigen::Vector3d out_W = Eigen::Vector3d::UnitZ();       ///< E.z: out of the cochlea.
  Eigen::Vector3d outward_W = Eigen::Vector3d::UnitX();   ///< E.x: toward the outer wall.
  Eigen::Vector3d vertical_W = Eigen::Vector3d::UnitY();  ///< E.y = E.z cross E.x.
};

/// What one point remembers between queries: which turn it is in. Queries update it.
struct LumenTrack {
  double angle = 0.0;         ///< Angle from the round window [rad], turns counted; <= 0 in the lead-in.
  double direction[2] = {1.0, 0.0};  ///< Unit vector (x, y) of that angle in W.
};

/// The wall as one point sees it.
struct WallPoint {
  bool isNear = false;     ///< Within reach. If not, nothing below is set.
  bool onMembrane = false; ///< The nearest wall is the basilar membrane.
  double distance = 0.0;   ///< From the point to the wall [m]; negative outside.
  // Curvatures are those of the surface parallel to the wall through the point: how fast the normal
  // turns as the point moves. Positive where the wall is concave.
  double curvature = 0.0;            ///< Along `along_W` [1/m].
  double lengthwiseCurvature = 0.0;  ///< Along the duct [1/m]; positive on the outer wall.
  Eigen::Vector3d normal_W = Eigen::Vector3d::Zero();  ///< Unit, from the wall into the lumen.
  Eigen::Vector3d along_W = Eigen::Vector3d::Zero();   ///< Unit, tangent to the wall in the section.
};

/// A duct with one opening. Immutable once built; every query is real-time safe.
class Lumen {
public:
  virtual ~Lumen() = default;

  virtual Entry entry() const noexcept = 0;

  /// The track of a point near the opening, to start queries from.
  virtual LumenTrack startTrack() const noexcept = 0;

  /// Finds the wall nearest to each point [m, W]. Points outside the opening see no wall.
  ///
  /// @param points_W  The points.
  /// @param reach     For each, the distance beyond which the wall need not be found [m].
  /// @param tracks    For each, its memory; brought up to date.
  /// @param walls     For each, the answer.
  ///
  /// Real-time safe.
  virtual void nearestWall(std::span<const Eigen::Vector3d> points_W, std::span<const double> reach,
                           std::span<LumenTrack> tracks, std::span<WallPoint> walls) const noexcept = 0;
};

}  // namespace perilymph::anatomy
