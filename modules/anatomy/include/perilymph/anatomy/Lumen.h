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
  bool inLeadIn = true;  ///< In the straight stretch before the round window.
  double angle = 0.0;    ///< Angle from the round window [rad], turns counted; 0 in the lead-in.
  double direction[2] = {1.0, 0.0};  ///< Unit vector (x, y) of that angle in W.
};

/// The wall as one point sees it: the signed distance D and how it changes.
struct WallPoint {
  bool isNear = false;  ///< Within reach. If not, only the clearance below is set.
  /// Not near: how far the point can move, whichever way, and still not be near [m]; 0 or less
  /// where that is not known.
  double clearance = 0.0;
  bool onMembrane = false;  ///< The nearest wall is the basilar membrane.
  double distance = 0.0;    ///< D, from the point to the wall [m]; negative outside.
  /// Gradient of D: unit, from the wall into the lumen. Shorter where two walls are equally near,
  /// as in a groove narrower than the array: there their pushes cancel.
  Eigen::Vector3d normal_W = Eigen::Vector3d::Zero();
  /// The positive part of minus the second derivative of D [1/m]: how fast the normal turns back as
  /// the point moves along a concave wall. Symmetric, positive semidefinite.
  Eigen::Matrix3d shapeOperator_W = Eigen::Matrix3d::Zero();
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
                           std::span<LumenTrack> tracks,
                           std::span<WallPoint> walls) const noexcept = 0;
};

}  // namespace perilymph::anatomy
