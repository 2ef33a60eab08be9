// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The interface of every anatomy to the mechanics: signed distance to the wall and the way in.

#include <Eigen/Core>
#include <algorithm>
#include <span>

#include "perilymph/foundation/Units.h"

namespace perilymph {
class Hash;
}

namespace perilymph::anatomy {

/// The opening and the direction of insertion: frame E. Right-handed, columns are unit vectors in
/// W.
struct Entry {
  Eigen::Vector3d origin_W = Eigen::Vector3d::Zero();     ///< Center of the opening [m].
  Eigen::Vector3d out_W = Eigen::Vector3d::UnitZ();       ///< E.z: out of the cochlea.
  Eigen::Vector3d outward_W = Eigen::Vector3d::UnitX();   ///< E.x: toward the outer wall.
  Eigen::Vector3d vertical_W = Eigen::Vector3d::UnitY();  ///< E.y = E.z cross E.x.
};

/// State of one point between queries: the turn it is in. Queries update it.
struct LumenTrack {
  bool inLeadIn = true;  ///< In the straight section before the round window.
  double angle = 0.0;    ///< Angle from the round window [rad], full turns included; 0 in the
                         ///< lead-in.
  double direction[2] = {1.0, 0.0};  ///< Unit vector (x, y) of that angle in W.

  /// Whether the point can be in front of the opening: within a quarter turn of it. The plane of the
  /// opening cuts the later turns too, and a point there is inside on both sides of it.
  bool isNearOpening() const noexcept { return angle < 0.5 * pi; }
};

/// Distance of a point behind the plane of the opening [m], negative in front of it; past the first
/// quarter turn at least 10 mm, whatever the plane. The one rule of what is inside. Real-time safe.
inline double behindOpening(const Entry& entry, const Eigen::Vector3d& point_W,
                            const LumenTrack& track) noexcept
{
  const double behind = (entry.origin_W - point_W).dot(entry.out_W);
  return track.isNearOpening() ? behind : std::max(behind, 10e-3);
}

/// The wall near a point: signed distance D and its derivatives.
struct WallPoint {
  bool isNear = false;  ///< Within reach. If false, only the clearance below is set.
  /// If not near: distance the point can move in any direction without being near [m]; 0 or less if
  /// unknown.
  double clearance = 0.0;
  bool onMembrane = false;  ///< The nearest wall is the basilar membrane.
  double distance = 0.0;    ///< D, from the point to the wall [m]; negative outside.
  /// Gradient of D: unit, from the wall into the lumen. Shorter where two walls are equally near,
  /// as in a groove narrower than the array: there their forces cancel.
  Eigen::Vector3d normal_W = Eigen::Vector3d::Zero();
  /// Positive part of minus the Hessian of D [1/m]: the rate at which the normal rotates as the
  /// point moves along a concave wall. Symmetric, positive semidefinite.
  Eigen::Matrix3d shapeOperator_W = Eigen::Matrix3d::Zero();
  Eigen::Matrix3d hessian_W = Eigen::Matrix3d::Zero();  ///< Second derivatives of D [1/m].
  /// Distance the point can move while D to second order, from the values above, is off by 10 nm at
  /// most, next to ridges by 40 nm (tested) [m]; 0 if unknown.
  double trustRadius = 0.0;
};

class ScalaTympani;

/// A duct with one opening. Immutable once built; every query is real-time safe after prepare().
class Lumen {
public:
  virtual ~Lumen() = default;

  /// Builds what queries read, once: up to some tenths of a second, not real-time safe. A query does it
  /// if nobody did. Any thread.
  virtual void prepare() const {}

  virtual Entry entry() const noexcept = 0;

  /// The lumen as a scala tympani, which has a membrane and a partition; null for any other duct.
  virtual const ScalaTympani* scala() const noexcept { return nullptr; }

  /// Initial track of a point near the opening.
  virtual LumenTrack startTrack() const noexcept = 0;

  /// Finds the nearest wall of each point [m, W]. Points outside the opening have no wall nearby.
  ///
  /// @param points_W  The points.
  /// @param reach     For each point, the distance beyond which the wall need not be found [m].
  /// @param tracks    State of each point; updated.
  /// @param walls     The result for each point.
  ///
  /// Real-time safe.
  virtual void nearestWall(std::span<const Eigen::Vector3d> points_W, std::span<const double> reach,
                           std::span<LumenTrack> tracks,
                           std::span<WallPoint> walls) const noexcept = 0;

  /// Updates the track of a point without looking for the wall. Does nothing where the wall does not
  /// depend on the track.
  ///
  /// Real-time safe.
  virtual void follow(const Eigen::Vector3d& point_W, LumenTrack& track) const noexcept
  {
    static_cast<void>(point_W);
    static_cast<void>(track);
  }

  /// Adds all data that the answers depend on to a model's fingerprint.
  virtual void addTo(Hash& hash) const noexcept = 0;
};

}  // namespace perilymph::anatomy
